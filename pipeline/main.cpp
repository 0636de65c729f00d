#include "pipeline/commands/run_program.h"
#include "values/large_pages.h"

int main(int argc, char** argv) {
    vantage::use_large_pages();
    return vantage::run_program(argc, argv);
}
