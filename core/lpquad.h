// The umbrella header of lpquad::lpquad: domains and surfaces to meshes, in one call or in steps.
// Files are read and written by lpquad_io.h.
#pragma once

#include "domain/domain.h"
#include "mesh/output_mesh.h"
#include "pipeline/mesh_domain.h"
#include "pipeline/mesher.h"
#include "pipeline/options.h"
#include "pipeline/report.h"
#include "pipeline/session.h"
#include "pipeline/snapshot.h"
#include "shell/mesh_surface.h"
#include "shell/options.h"
#include "shell/output.h"
