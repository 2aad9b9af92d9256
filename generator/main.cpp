#include "cli/command_line.h"

int main(int argc, char** argv) { return collage::run_command_line(argc, argv); }
