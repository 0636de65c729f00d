#include "pipeline/commands/run_program.h"

int main(int argc, char** argv) { return vantage::run_program(argc, argv); }
