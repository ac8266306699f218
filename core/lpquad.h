// The umbrella header: everything a user of the library needs.
#pragma once

#include "domain/domain.h"
#include "mesh/output_mesh.h"
#include "pipeline/mesh_domain.h"
#include "pipeline/mesher.h"
#include "pipeline/options.h"
#include "pipeline/report.h"
