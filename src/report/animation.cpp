// SPDX-License-Identifier: Apache-2.0
#include "jprim/report/animation.h"

#include "base/format.h"
#include "jprim/base/error.h"
#include "report/decorations.h"
#include "report/describe.h"

namespace jprim {

using SimTK::MobilizedBody;
using SimTK::MobilizedBodyIndex;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;

namespace {

/// Shapes and markers that are collected for a page.
class Scene {
public:
    void add(const DrawnShape& shape, const std::vector<size_t>& parts) {
        const std::string id = fmt::format("geometry {}", m_graphics.size() + 1);
        Json graphic = {{"id", id}, {"shape", shape.shape}, {"values", shape.values}};
        std::vector<int> ids;
        for (size_t k = 0; k < shape.markers.size(); ++k) {
            ids.push_back(int(m_markers.size()) + 1);
            m_markers.push_back(
                {{"id", ids.back()}, {"part", parts[k]}, {"pose", makeJson(shape.markers[k])}});
        }
        if (shape.shape == "OUTLINE")
            graphic["points"] = ids;
        else
            graphic["marker"] = ids[0];
        m_graphics.push_back(std::move(graphic));
    }

    const Json& getMarkers() const { return m_markers; }
    const Json& getGraphics() const { return m_graphics; }

private:
    Json m_markers = Json::array(), m_graphics = Json::array();
};

// Ground, and places of what moves by itself.
SimTK::MassProperties makeMassless() {
    return {0, SimTK::Vec3(0), SimTK::Inertia(0)};
}

Json makePart(const std::string& id, const SimTK::MassProperties& mass) {
    const SimTK::SymMat33 I = mass.calcCentralInertia().asSymMat33();
    return {{"id", id},
            {"ground", false},
            {"mass", mass.getMass()},
            {"cm", makeJson(mass.getMassCenter())},
            {"inertia", {I(0, 0), I(1, 1), I(2, 2), -I(1, 0), -I(2, 0), -I(2, 1)}},
            {"parent", nullptr},
            {"joint", nullptr}};
}

}  // namespace

class Animation::Recording {
public:
    Recording(const SimTK::MultibodySystem& system, const std::string& title)
        : m_system(system), m_title(title), m_matter(system.getMatterSubsystem()) {}

    void addCurve(const std::string& name, const std::string& unit,
                  std::function<SimTK::Real(const State&)> calc) {
        if (!m_times.empty()) throw Error(name, "is to be added to the animation before the first frame");
        m_curves.push_back({name, unit, std::move(calc), {}});
    }

    void record(const State& state) {
        if (m_times.empty()) describeSystem(state);
        m_times.push_back(state.getTime());
        for (MobilizedBodyIndex b(0); b < m_matter.getNumBodies(); ++b)
            m_bodyPoses.push_back(m_matter.getMobilizedBody(b).getBodyTransform(state));
        recordMoving(state);
        for (Curve& curve : m_curves) curve.values.push_back(curve.calc(state));
    }

    int getNumFrames() const { return int(m_times.size()); }
    void write(const std::string& path) const;

private:
    struct Curve {
        std::string name, unit;
        std::function<SimTK::Real(const State&)> calc;
        std::vector<double> values;
    };
    struct Placed {
        DrawnShape shape;
        MobilizedBodyIndex body;
    };

    std::vector<Placed> collect(const State& state, Stage first, Stage last) const {
        SimTK::Array_<SimTK::DecorativeGeometry> geometry;
        for (Stage stage = first; stage <= last; ++stage)
            m_system.calcDecorativeGeometryAndAppend(state, stage, geometry);
        std::vector<Placed> placed;
        for (const SimTK::DecorativeGeometry& one : geometry)
            for (DrawnShape& shape : readDecoration(one))
                placed.push_back({std::move(shape), MobilizedBodyIndex(std::max(one.getBodyId(), 0))});
        return placed;
    }

    void describeSystem(const State& state) {
        m_fixed = collect(state, Stage::Topology, Stage::Instance);
        for (MobilizedBodyIndex b(0); b < m_matter.getNumBodies(); ++b) {
            const MobilizedBody& body = m_matter.getMobilizedBody(b);
            m_parts.push_back(makePart(fmt::format("body {}", int(b)),
                                       b == 0 ? makeMassless() : body.getBodyMassProperties(state)));
            if (b > 0)
                m_parts.back()["parent"] =
                    fmt::format("body {}", int(body.getParentMobilizedBody().getMobilizedBodyIndex()));
        }
        m_parts[0]["ground"] = true;
    }

    // What is made anew for each state, such as lines between bodies, has places of its own.
    void recordMoving(const State& state) {
        std::vector<Transform> poses;
        std::vector<Placed> moving = collect(state, Stage::Time, state.getSystemStage());
        for (const Placed& placed : moving)
            for (const Transform& X_BM : placed.shape.markers)
                poses.push_back(m_matter.getMobilizedBody(placed.body).getBodyTransform(state) * X_BM);
        m_movingPoses.push_back(std::move(poses));
        if (moving.size() > m_moving.size()) m_moving = std::move(moving);
    }

    // Of a place that the frame does not have, from the nearest earlier or else later frame that has it.
    const Transform& findMovingPose(size_t frame, size_t place) const {
        for (size_t k = frame + 1; k-- > 0;)
            if (place < m_movingPoses[k].size()) return m_movingPoses[k][place];
        while (place >= m_movingPoses[frame].size()) ++frame;
        return m_movingPoses[frame][place];
    }

    Json makeMesh(const Placed& placed, ReportData& data) const;
    void describeShapes(ReportData& data) const;
    Json makeFrames(ReportData& data) const;
    Json makeTables(ReportData& data) const;

    const SimTK::MultibodySystem& m_system;
    std::string m_title;
    const SimTK::SimbodyMatterSubsystem& m_matter;
    std::vector<Curve> m_curves;
    std::vector<Placed> m_fixed, m_moving;
    Json m_parts = Json::array();
    std::vector<double> m_times;
    std::vector<Transform> m_bodyPoses;
    std::vector<std::vector<Transform>> m_movingPoses;  // of each frame, in ground
};

// A mesh that does not deform is one with a mode that does nothing.
Json Animation::Recording::makeMesh(const Placed& placed, ReportData& data) const {
    std::vector<float> points;
    for (const SimTK::Vec3& p : placed.shape.points)
        for (int k = 0; k < 3; ++k) points.push_back(float(p[k]));
    const size_t n = placed.shape.points.size();
    return {{"part", int(placed.body)},
            {"points", data.addArray(points, {n, 3})},
            {"faces", placed.shape.faces},
            {"modes", data.addArray(std::vector<float>(3 * n), {1, n, 3})},
            {"amplitudes", data.addArray(std::vector<float>(m_times.size()), {m_times.size(), 1})}};
}

void Animation::Recording::describeShapes(ReportData& data) const {
    Scene scene;
    Json parts = m_parts, meshes = Json::array();
    for (const Placed& placed : m_fixed) {
        if (placed.shape.shape == "MESH")
            meshes.push_back(makeMesh(placed, data));
        else
            scene.add(placed.shape, std::vector<size_t>(placed.shape.markers.size(), size_t(placed.body)));
    }
    for (Placed placed : m_moving) {
        std::vector<size_t> places;
        for (Transform& X : placed.shape.markers) {
            places.push_back(parts.size());
            parts.push_back(
                makePart(fmt::format("place {}", parts.size() - m_parts.size() + 1), makeMassless()));
            parts.back()["ground"] = true;  // no body is drawn there
            X = Transform();
        }
        if (!places.empty()) scene.add(placed.shape, places);
    }
    data.json["parts"] = std::move(parts);
    data.json["markers"] = scene.getMarkers();
    data.json["elements"] = Json::array();
    data.json["graphics"] = scene.getGraphics();
    data.json["flexible"] = std::move(meshes);
}

Json Animation::Recording::makeFrames(ReportData& data) const {
    const size_t bodies = m_parts.size(), places = data.json["parts"].size() - bodies;
    std::vector<float> poses;
    for (size_t frame = 0; frame < m_times.size(); ++frame) {
        for (size_t body = 0; body < bodies; ++body) appendPose(m_bodyPoses[frame * bodies + body], poses);
        for (size_t place = 0; place < places; ++place) appendPose(findMovingPose(frame, place), poses);
    }
    return {{"time", data.addArray(m_times, {m_times.size()})},
            {"poses", data.addArray(poses, {m_times.size(), bodies + places, 7})}};
}

Json Animation::Recording::makeTables(ReportData& data) const {
    if (m_curves.empty()) return Json::array();
    Json columns = Json::array();
    std::vector<double> values;
    for (const Curve& curve : m_curves) {
        columns.push_back({{"name", curve.name}, {"unit", curve.unit}, {"element", nullptr}});
        values.insert(values.end(), curve.values.begin(), curve.values.end());
    }
    return Json::array({{{"name", "requests"},
                         {"columns", columns},
                         {"time", data.addArray(m_times, {m_times.size()})},
                         {"data", data.addArray(values, {m_curves.size(), m_times.size()})}}});
}

void Animation::Recording::write(const std::string& path) const {
    if (m_times.empty()) throw Error(path, "no frame of the animation has been recorded");
    ReportData data;
    data.json = {{"format", 1},
                 {"title", m_title},
                 {"units", {{"length", ""}, {"force", ""}, {"mass", ""}, {"time", "s"}}},
                 {"text", Json::object()}};
    data.json["gravity"] = {0, -1, 0};
    describeShapes(data);
    data.json["frames"] = makeFrames(data);
    data.json["tables"] = makeTables(data);
    data.write(path);
}

Animation::Animation(const SimTK::MultibodySystem& system, const std::string& title)
    : m_recording(std::make_unique<Recording>(system, title)) {}
Animation::~Animation() = default;
Animation::Animation(Animation&&) noexcept = default;
Animation& Animation::operator=(Animation&&) noexcept = default;

void Animation::addCurve(const std::string& name, const std::string& unit,
                         std::function<SimTK::Real(const State&)> calc) {
    m_recording->addCurve(name, unit, std::move(calc));
}

void Animation::record(const State& state) {
    m_recording->record(state);
}

int Animation::getNumFrames() const {
    return m_recording->getNumFrames();
}

void Animation::write(const std::string& path) const {
    m_recording->write(path);
}

}  // namespace jprim
