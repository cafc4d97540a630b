// SPDX-License-Identifier: Apache-2.0
// GRAPHICS: every shape is read, written and read again as what it was; and what is wrong with it is said.
#include "dataset/error_cases.h"
#include "jprim/dataset/write_dataset.h"

namespace jprim {
namespace {

GraphicsStatement readGraphics(const std::string& arguments) {
    const Dataset dataset = readGood("GRAPHICS/7, " + arguments);
    EXPECT_EQ(dataset.graphics.size(), 1u) << arguments;
    return dataset.graphics.at(0);
}

TEST(DatasetGraphics, ShapesOfParts) {
    const GraphicsStatement cylinder =
        readGraphics("CYLINDER\n, CM = 2\n, LENGTH = 4, RADIUS = 0.1, RANGLE=180D, SIDES=20, SEG=40");
    EXPECT_EQ(cylinder.shape, GraphicsShape::Cylinder);
    EXPECT_EQ(cylinder.id, 7);
    EXPECT_EQ(cylinder.cm, 2);
    EXPECT_EQ(cylinder.length, 4);
    EXPECT_EQ(cylinder.radius, 0.1);
    EXPECT_NEAR(cylinder.rangle.value(), 3.14159265358979, 1e-13);
    EXPECT_EQ(cylinder.sides, 20);
    EXPECT_EQ(cylinder.seg, 40);
    EXPECT_EQ(readGraphics("CYL, CM=2, LEN=1, RM=1").rm, 1);
    const GraphicsStatement box = readGraphics("BOX, CORNER = 2, X = 0.2, Y = -1, Z = 0");
    EXPECT_EQ(box.corner, 2);
    EXPECT_EQ(box.size[1], -1);
    EXPECT_EQ(box.size[2], 0);
    EXPECT_EQ(readGraphics("ELLIPSOID, CM=2, XS = 0.2, YS = 0.3, ZSCALE = 0.4").scale[1], 0.3);
    const GraphicsStatement frustum = readGraphics("FRUSTUM, CM=2, TOP=1, BOTTOM=2, LENGTH=3");
    EXPECT_EQ(frustum.top, 1);
    EXPECT_EQ(frustum.bottom, 2);
    EXPECT_EQ(readGraphics("CIRCLE, CM=2, RADIUS=3").radius, 3);
    EXPECT_EQ(readGraphics("ARC, CM=2, RADIUS=3, RANGLE=1.5").rangle, 1.5);
    const GraphicsStatement outline = readGraphics("OUTLINE = 1, 2, 1");
    EXPECT_EQ(outline.shape, GraphicsShape::Outline);
    EXPECT_EQ(outline.outline, (std::vector<int>{1, 2, 1}));
}

TEST(DatasetGraphics, Springs) {
    const GraphicsStatement spring =
        readGraphics("SPDP, I = 1, J = 2, COILS = 0, DA=0.4, DB = 0.2, DC = 0.16, LA=1, LB=2, LC=3, LD=4");
    EXPECT_EQ(spring.shape, GraphicsShape::SpringDamper);
    EXPECT_EQ(spring.i, 1);
    EXPECT_EQ(spring.j, 2);
    EXPECT_EQ(spring.coils, 0);
    EXPECT_EQ(spring.da, 0.4);
    EXPECT_EQ(spring.dc, 0.16);
    EXPECT_EQ(spring.ld, 4);
}

TEST(DatasetGraphics, WhatIsNotDrawnIsKept) {
    EXPECT_EQ(readGraphics("FORCE, ETYPE = SFORCE, EID = 1, EMARKER = 2").forceKind, "SFORCE");
    EXPECT_EQ(readGraphics("CURVE, CID=3, CRM=2, SEG=50").crm, 2);
    EXPECT_EQ(readGraphics("EXTERNAL, RM=2, FILE=crank.xmt_txt, ELEMENT=SOLID1").file, "crank.xmt_txt");
    EXPECT_EQ(readGraphics("PLANE, RM=2, XMIN=-1, XMAX=1, YMIN=-2, YMAX=2").limits[2], -2);
    EXPECT_EQ(readGraphics("POINT, RM=2").shape, GraphicsShape::Point);
    const Dataset torus = readGood("GRAPHICS/7, TORUS, CM=2, QQQ=3");
    EXPECT_TRUE(torus.graphics.empty());
    EXPECT_EQ(torus.ignored.at(0).arguments, "TORUS, CM=2, QQQ=3");
}

TEST(DatasetGraphics, WrittenAndReadAgain) {
    const Dataset dataset = readGood(
        "GRAPHICS/1, CYLINDER, CM=2, LENGTH=4, RM=1, RANGLE=1, SIDES=6, SEG=7\nGRAPHICS/2, BOX, CORNER=1, X=1, Y=0, Z=3\n"
        "GRAPHICS/3, ELLIPSOID, CM=1, XSCALE=1, YSCALE=2, ZSCALE=3\nGRAPHICS/4, OUTLINE=1,2\n"
        "GRAPHICS/5, FRUSTUM, CM=1, TOP=0, BOTTOM=1, LENGTH=-2\nGRAPHICS/6, SPDP, I=1, J=2, COILS=0, DB=1, LD=2\n"
        "GRAPHICS/7, EXTERNAL, RM=1, FILE=a b.x_t\nGRAPHICS/8, FORCE, ETYPE=JOINT, EID=9, EMARKER=2\n"
        "GRAPHICS/9, PLANE, RM=1, XMIN=0, XMAX=1, YMIN=2, YMAX=3\nGRAPHICS/10, CURVE, CID=4, CRM=1\n"
        "GRAPHICS/11, ARC, CM=1, RADIUS=1, RANGLE=2, SEG=3\nGRAPHICS/12, CIRCLE, CM=1, RADIUS=1");
    ASSERT_EQ(dataset.graphics.size(), 12u);
    const std::string text = writeDataset(dataset);
    Diagnostics diagnostics;
    EXPECT_EQ(readDataset(text, diagnostics), dataset) << text;
    EXPECT_NE(text.find("GRAPHICS/2, BOX, CORNER=1, X=1, Y=0, Z=3\n"), std::string::npos) << text;
    EXPECT_NE(text.find("GRAPHICS/4, OUTLINE=1, 2\n"), std::string::npos) << text;
    EXPECT_NE(dataset, readGood("GRAPHICS/1, CYLINDER, CM=2, LENGTH=4, RM=1"));
}

TEST(DatasetGraphics, Mistakes) {
    check({
        {"nothing", "GRAPHICS/1",
         "3:1: error: GRAPHICS/1 needs what to draw: CYLINDER, BOX, ELLIPSOID, FRUSTUM, CIRCLE, ARC, OUTLINE= or SPDP"},
        {"a misspelt shape", "GRAPHICS/1, CYLINDRE, CM=1",
         "3:13: error: unknown argument 'CYLINDRE' of GRAPHICS/1; did you mean CYLINDER?"},
        {"two shapes", "GRAPHICS/1, BOX, CIRCLE, CM=1",
         "3:18: error: GRAPHICS/1 cannot be both BOX and CIRCLE"},
        {"no such marker", "GRAPHICS/1, CIRCLE, CM=99, RADIUS=1",
         "3:24: error: CM of GRAPHICS/1: there is no MARKER/99"},
        {"no such marker of an outline", "GRAPHICS/1, OUTLINE=1, 98, 2",
         "3:24: error: OUTLINE of GRAPHICS/1: there is no MARKER/98"},
        {"what is missing", "GRAPHICS/1, BOX, CORNER=1, X=1, Z=1", "3:1: error: GRAPHICS/1 needs Y: Y="},
        {"no radius", "GRAPHICS/1, CYLINDER, CM=1, LENGTH=1",
         "3:1: error: GRAPHICS/1 needs its radius: RADIUS=, or RM=, a marker that far from the axis"},
        {"two radii", "GRAPHICS/1, CYLINDER, CM=1, LENGTH=1, RADIUS=2, RM=2",
         "3:39: error: GRAPHICS/1 takes RADIUS or RM, not both"},
        {"what belongs to another shape", "GRAPHICS/1, CIRCLE, CM=1, RADIUS=2, COILS=3",
         "3:37: error: COILS of GRAPHICS/1: CIRCLE does not take it"},
        {"a number that is none", "GRAPHICS/1, CIRCLE, CM=1, RADIUS=QQQ",
         "3:34: error: RADIUS of GRAPHICS/1: 'QQQ' is not a number; write it like 1.5 or 1.5E3"},
    });
}

}  // namespace
}  // namespace jprim
