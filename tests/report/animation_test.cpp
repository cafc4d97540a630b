// SPDX-License-Identifier: Apache-2.0
// A Simbody system's decorative geometry, as a page reads it.
#include "jprim/report/animation.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "jprim/report/write_report.h"
#include "report/decorations.h"
#include "report/report_reader.h"
#include "support/expect_error.h"

namespace jprim {
namespace {

using SimTK::Vec3;

class AnimationTest : public ::testing::Test {
protected:
    AnimationTest() {
        SimTK::Body::Rigid body(SimTK::MassProperties(2, Vec3(0), SimTK::Inertia(1, 2, 3)));
        body.addDecoration(SimTK::Transform(Vec3(1, 0, 0)), SimTK::DecorativeBrick(Vec3(0.1, 0.2, 0.3)));
        m_body = SimTK::MobilizedBody::Slider(m_matter.Ground(), body);
        m_matter.setShowDefaultGeometry(false);
        m_state = m_system.realizeTopology();
    }

    void record(Animation& animation, double time, double position) {
        m_state.setTime(time);
        m_body.setLength(m_state, position);
        m_system.realize(m_state, SimTK::Stage::Position);
        animation.record(m_state);
    }

    SimTK::MultibodySystem m_system;
    SimTK::SimbodyMatterSubsystem m_matter{m_system};
    SimTK::MobilizedBody::Slider m_body;
    SimTK::State m_state;
    std::string m_path =
        (std::filesystem::temp_directory_path() / ("jprim_animation_" + std::to_string(getpid()) + ".html"))
            .string();
};

TEST_F(AnimationTest, BodiesAndCurves) {
    if (!canWriteReports()) GTEST_SKIP() << "jprim was built without the page of reports";
    Animation animation(m_system, "slides");
    animation.addCurve("place", "m", [this](const SimTK::State& s) { return m_body.getLength(s); });
    record(animation, 0, 0.5);
    record(animation, 2, -0.5);
    EXPECT_EQ(animation.getNumFrames(), 2);
    animation.write(m_path);
    const testing::ReportReader report(m_path);
    std::filesystem::remove(m_path);
    EXPECT_EQ(report.json["title"], "slides");
    ASSERT_EQ(report.json["parts"].size(), 2u);
    EXPECT_EQ(report.json["parts"][0]["ground"], true);
    EXPECT_EQ(report.json["parts"][1]["mass"], 2);
    EXPECT_EQ(report.json["parts"][1]["inertia"][2], 3);
    ASSERT_EQ(report.json["graphics"].size(), 1u);
    EXPECT_EQ(report.json["graphics"][0]["shape"], "BOX");
    EXPECT_EQ(report.json["graphics"][0]["values"].dump(), R"({"x":0.2,"y":0.4,"z":0.6})");
    EXPECT_NEAR(report.json["markers"][0]["pose"][0].get<double>(), 0.9, 1e-12);  // the corner
    EXPECT_EQ(report.json["markers"][0]["part"], 1);
    EXPECT_EQ(report.read(report.json["frames"]["time"]), (std::vector<double>{0, 2}));
    const std::vector<double> poses = report.read(report.json["frames"]["poses"]);
    EXPECT_EQ(poses[7], 0.5);
    EXPECT_EQ(poses[21], -0.5);
    EXPECT_EQ(report.read(report.findTable("requests")["data"]), (std::vector<double>{0.5, -0.5}));
}

TEST_F(AnimationTest, LinesBetweenBodiesFollow) {
    if (!canWriteReports()) GTEST_SKIP() << "jprim was built without the page of reports";
    SimTK::DecorationSubsystem decorations(m_system);
    decorations.addRubberBandLine(m_matter.Ground().getMobilizedBodyIndex(), Vec3(0, 5, 0),
                                  m_body.getMobilizedBodyIndex(), Vec3(0), SimTK::DecorativeLine());
    m_state = m_system.realizeTopology();
    Animation animation(m_system);
    record(animation, 0, 0.5);
    record(animation, 1, 2);
    animation.write(m_path);
    const testing::ReportReader report(m_path);
    std::filesystem::remove(m_path);
    const auto& line = report.json["graphics"][1];
    EXPECT_EQ(line["shape"], "OUTLINE");
    const std::vector<double> poses = report.read(report.json["frames"]["poses"]);
    const size_t parts = report.json["parts"].size();
    for (size_t frame = 0; frame < 2; ++frame) {
        const auto findPlace = [&](size_t end) {
            const size_t marker = line["points"][end].get<size_t>() - 1;
            return (frame * parts + report.json["markers"][marker]["part"].get<size_t>()) * 7;
        };
        EXPECT_EQ(poses[findPlace(0) + 1], 5);
        EXPECT_EQ(poses[findPlace(1)], frame == 0 ? 0.5 : 2);
    }
}

TEST_F(AnimationTest, Mistakes) {
    Animation animation(m_system);
    EXPECT_EQ(testing::catchError([&] { animation.write("none.html"); }),
              "none.html: no frame of the animation has been recorded");
    record(animation, 0, 0);
    EXPECT_EQ(testing::catchError([&] { animation.addCurve("late", "", {}); }),
              "late: is to be added to the animation before the first frame");
}

TEST(Decorations, Shapes) {
    const auto describe = [](const SimTK::DecorativeGeometry& geometry) {
        std::string text;
        for (const DrawnShape& shape : readDecoration(geometry)) text += shape.shape + shape.values.dump();
        return text;
    };
    EXPECT_EQ(describe(SimTK::DecorativeSphere(2)), R"(ELLIPSOID{"xscale":4.0,"yscale":4.0,"zscale":4.0})");
    EXPECT_EQ(describe(SimTK::DecorativeSphere(2).setScaleFactors(Vec3(1, 2, 3))),
              R"(ELLIPSOID{"xscale":4.0,"yscale":8.0,"zscale":12.0})");
    EXPECT_EQ(describe(SimTK::DecorativeCylinder(1, 3)), R"(CYLINDER{"length":6.0,"radius":1.0})");
    EXPECT_EQ(describe(SimTK::DecorativeCircle(3)), R"(CIRCLE{"radius":3.0})");
    EXPECT_EQ(describe(SimTK::DecorativeFrame(1)), "OUTLINE{}OUTLINE{}OUTLINE{}");
    EXPECT_EQ(describe(SimTK::DecorativeText("text")), "");
    // A cylinder of Simbody's is along y and around its origin, one of a page along z and from it.
    const SimTK::Transform X = readDecoration(SimTK::DecorativeCylinder(1, 3))[0].markers[0];
    EXPECT_LT((X.p() - Vec3(0, -3, 0)).norm(), 1e-12);
    EXPECT_LT((X.z() - Vec3(0, 1, 0)).norm(), 1e-12);
    const DrawnShape mesh =
        readDecoration(SimTK::DecorativeMesh(SimTK::PolygonalMesh::createBrickMesh(Vec3(1))))[0];
    EXPECT_EQ(mesh.shape, "MESH");
    EXPECT_EQ(mesh.points.size(), 26u);
    EXPECT_EQ(mesh.faces.size(), 48u);
}

}  // namespace
}  // namespace jprim
