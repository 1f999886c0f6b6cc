/* The same of .cp files. */
#define FUZZ_NAME "p.cp"
#include "tests/fuzz/fuzz_fold.c"
