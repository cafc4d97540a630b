// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_DATASET_GRAPHICS_STATEMENT_H_
#define JPRIM_DATASET_GRAPHICS_STATEMENT_H_

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "jprim/base/diagnostic.h"

namespace jprim {

enum class GraphicsShape {
    Arc,
    Box,
    Circle,
    Curve,
    Cylinder,
    Ellipsoid,
    External,
    Force,
    Frustum,
    Outline,
    Plane,
    Point,
    SpringDamper
};

/// GRAPHICS: what a part, a spring or a force looks like. No motion depends on it. Curve, External, Force, Plane and
/// Point are kept and not drawn by jprim.
struct GraphicsStatement {
    SourcePosition where;
    int id = 0;
    GraphicsShape shape = GraphicsShape::Cylinder;
    int cm = 0;      ///< centre, of a Cylinder and a Frustum that of the bottom; +z is their axis
    int corner = 0;  ///< of a Box
    std::array<std::optional<double>, 3> size;  ///< X Y Z: of a Box along the corner's axes
    std::array<std::optional<double>, 3>
        scale;  ///< XSCALE YSCALE ZSCALE: the axes of an Ellipsoid, twice its radii
    std::optional<double> length;
    std::optional<double> radius;
    int rm = 0;  ///< instead of a radius a marker that far from the z axis of cm; else the frame
    std::optional<double> top;  ///< radii of a Frustum
    std::optional<double> bottom;
    std::optional<double> rangle;  ///< how far round, from the x axis [rad]; all round if not given
    std::optional<double> sides;   ///< flat sides of the round
    std::optional<double> seg;     ///< lines of a circle
    std::vector<int> outline;      ///< markers joined by lines
    int i = 0;                     ///< ends of a SpringDamper
    int j = 0;
    std::optional<double> coils;
    std::optional<double> da;                     ///< diameter of the coils
    std::optional<double> db;                     ///< diameter of the damper at i
    std::optional<double> dc;                     ///< diameter of the damper at j
    std::optional<double> la;                     ///< from i to the coils
    std::optional<double> lb;                     ///< from j to the coils
    std::optional<double> lc;                     ///< from i to the damper
    std::optional<double> ld;                     ///< from j to the damper
    std::array<std::optional<double>, 4> limits;  ///< XMIN XMAX YMIN YMAX of a Plane
    int curve = 0;                                ///< CID and CRM of a Curve
    int crm = 0;
    std::string file;  ///< FILE and ELEMENT of an External
    std::string element;
    std::string forceKind;  ///< ETYPE, EID and EMARKER of a Force
    int force = 0;
    int forceMarker = 0;
};

/// Adams' word in full and upper case: "CYLINDER", "SPDP".
const char* getAdamsName(GraphicsShape shape);

}  // namespace jprim

#endif
