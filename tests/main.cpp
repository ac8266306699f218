// The test runner's main, compiled once.
#ifdef LPQ_CATCH_V2
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#endif
