#include "base/files/large_pages.h"
#include "pipeline/commands/shared/run_program.h"

int main(int argc, char** argv) {
    vantage::use_large_pages();
    return vantage::run_program(argc, argv);
}
