// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_REPORT_DECORATIONS_H_
#define JPRIM_SRC_REPORT_DECORATIONS_H_

#include <string>
#include <vector>

#include "SimTKsimbody.h"
#include "report/report_data.h"

namespace jprim {

/// What a page draws: one of its shapes, on as many markers as that has.
struct DrawnShape {
    std::string shape;  ///< "BOX"; "MESH" of points that are joined by faces
    Json values = Json::object();
    std::vector<SimTK::Transform> markers;  ///< poses in the frame of the body
    std::vector<SimTK::Vec3> points;
    std::vector<std::vector<int>> faces;
};

/// Simbody's decorative geometry as shapes of the page; none of what the page cannot draw.
std::vector<DrawnShape> readDecoration(const SimTK::DecorativeGeometry& geometry);

}  // namespace jprim

#endif
