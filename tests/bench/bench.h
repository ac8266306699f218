// The benchmarks behind lpquad_bench; arguments without the program's and the benchmark's name.
#pragma once

namespace lpq_bench {

int pipeline(int argc, char** argv);
int energy(int argc, char** argv);
int matching(int argc, char** argv);
int surface(int argc, char** argv);

}  // namespace lpq_bench
