// Catch2 version 2 (Debian 12) and version 3 (Debian 13) behind one include.
#pragma once

#ifdef LPQ_CATCH_V2
#include <catch2/catch.hpp>
namespace lpq_test {
using Catch::Detail::Approx;
}
#else
#include <catch2/catch_all.hpp>
namespace lpq_test {
using Catch::Approx;
}
#endif
