// What repair did, in sentences.
#pragma once

#include <vector>

#include "surface/repair.h"

namespace lpq {

/// One warning per kind of repair that a person should know of. Welded and unused points are left
/// to the report: every STL file has them.
std::vector<Warning> repair_warnings(const RepairReport& report);

}  // namespace lpq
