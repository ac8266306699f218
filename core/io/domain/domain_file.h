// What a domain reader hands over: the domain as the file says it, and what it had to leave out.
#pragma once

#include <vector>

#include "domain/domain.h"

namespace lpq {

struct DomainFile {
  DomainInput domain;
  std::vector<Warning> warnings;  // gaps closed, entities skipped; for the report
};

}  // namespace lpq
