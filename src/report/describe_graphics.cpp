// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/format.h"
#include "report/describe.h"

namespace jprim {

using SimTK::Transform;
using SimTK::Vec3;

namespace {

void put(Json& values, const char* name, const std::optional<double>& value) {
    if (value) values[name] = *value;
}

class Describer {
public:
    Describer(const Mechanism& mechanism, const Motion& motion) : m_mechanism(mechanism), m_motion(motion) {}

    /// Null of what is not drawn.
    Json describe(const GraphicsStatement& g) const {
        Json json = {{"id", fmt::format("GRAPHICS/{}", g.id)}, {"shape", getAdamsName(g.shape)}};
        switch (g.shape) {
            case GraphicsShape::Box: json["marker"] = g.corner; break;
            case GraphicsShape::Outline: json["points"] = g.outline; break;
            case GraphicsShape::SpringDamper:
                json["i"] = g.i;
                json["j"] = g.j;
                break;
            case GraphicsShape::Arc:
            case GraphicsShape::Circle:
            case GraphicsShape::Cylinder:
            case GraphicsShape::Ellipsoid:
            case GraphicsShape::Frustum: json["marker"] = g.cm; break;
            default: return nullptr;
        }
        json["values"] = makeValues(g);
        return json;
    }

private:
    Json makeValues(const GraphicsStatement& g) const {
        Json values = Json::object();
        put(values, "x", g.size[0]);
        put(values, "y", g.size[1]);
        put(values, "z", g.size[2]);
        put(values, "xscale", g.scale[0]);
        put(values, "yscale", g.scale[1]);
        put(values, "zscale", g.scale[2]);
        put(values, "length", g.length);
        put(values, "radius", g.rm == 0 ? g.radius : findRadius(g.cm, g.rm));
        put(values, "top", g.top);
        put(values, "bottom", g.bottom);
        put(values, "angle", g.rangle);
        put(values, "coils", g.coils);
        put(values, "da", g.da);
        put(values, "db", g.db);
        put(values, "dc", g.dc);
        put(values, "la", g.la);
        put(values, "lb", g.lb);
        put(values, "lc", g.lc);
        put(values, "ld", g.ld);
        return values;
    }

    // How far a marker is from the axis of another at the start.
    std::optional<double> findRadius(int cm, int rm) const {
        const Vec3 r = ~findPoseAtStart(cm) * findPoseAtStart(rm).p();
        return std::hypot(r[0], r[1]);
    }

    Transform findPoseAtStart(int id) const {
        const Marker& marker = m_mechanism.getMarker(id);
        const size_t part = m_motion.findPart(marker);
        const Transform onPart = m_motion.findPoseOnPart(marker, part);
        return m_motion.getNumFrames() == 0 ? onPart : m_motion.calcPose(0, part) * onPart;
    }

    const Mechanism& m_mechanism;
    const Motion& m_motion;
};

}  // namespace

Json describeGraphics(const Dataset& dataset, const Mechanism& mechanism, const Motion& motion) {
    const Describer describer(mechanism, motion);
    Json graphics = Json::array();
    for (const GraphicsStatement& statement : dataset.graphics) {
        Json described = describer.describe(statement);
        if (!described.is_null()) graphics.push_back(std::move(described));
    }
    return graphics;
}

}  // namespace jprim
