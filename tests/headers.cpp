// Precompiles catch.h for the tests of all rooms (LPQ_PCH).
