// SPDX-License-Identifier: Apache-2.0
#include "report/decorations.h"

namespace jprim {

using SimTK::Real;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::UnitVec3;
using SimTK::Vec3;

namespace {

// An axis of a page's cylinder is z.
Transform alongZ(const Vec3& origin, const UnitVec3& direction) {
    return {Rotation(direction, SimTK::ZAxis), origin};
}

class DecorationReader final : public SimTK::DecorativeGeometryImplementation {
public:
    std::vector<DrawnShape> shapes;

    void implementPointGeometry(const SimTK::DecorativePoint&) override {}
    void implementTextGeometry(const SimTK::DecorativeText&) override {}

    void implementLineGeometry(const SimTK::DecorativeLine& line) override {
        addLine(line, line.getPoint1(), line.getPoint2());
    }
    void implementArrowGeometry(const SimTK::DecorativeArrow& arrow) override {
        addLine(arrow, arrow.getStartPoint(), arrow.getEndPoint());
    }
    void implementFrameGeometry(const SimTK::DecorativeFrame& frame) override {
        for (int k = 0; k < 3; ++k) {
            Vec3 tip(0);
            tip[k] = frame.getAxisLength();
            addLine(frame, Vec3(0), tip);
        }
    }
    void implementBrickGeometry(const SimTK::DecorativeBrick& brick) override {
        const Vec3 half = brick.getHalfLengths().elementwiseMultiply(getScale(brick));
        add("BOX", brick, Transform(-half), {{"x", 2 * half[0]}, {"y", 2 * half[1]}, {"z", 2 * half[2]}});
    }
    void implementSphereGeometry(const SimTK::DecorativeSphere& sphere) override {
        addEllipsoid(sphere, Vec3(sphere.getRadius()));
    }
    void implementEllipsoidGeometry(const SimTK::DecorativeEllipsoid& ellipsoid) override {
        addEllipsoid(ellipsoid, ellipsoid.getRadii());
    }
    void implementCylinderGeometry(const SimTK::DecorativeCylinder& cylinder) override {
        const Vec3 scale = getScale(cylinder);
        const Real half = cylinder.getHalfHeight() * scale[1];
        add("CYLINDER", cylinder, alongZ(Vec3(0, -half, 0), UnitVec3(SimTK::YAxis)),
            {{"length", 2 * half}, {"radius", cylinder.getRadius() * scale[0]}});
    }
    void implementCircleGeometry(const SimTK::DecorativeCircle& circle) override {
        add("CIRCLE", circle, Transform(), {{"radius", circle.getRadius() * getScale(circle)[0]}});
    }
    void implementTorusGeometry(const SimTK::DecorativeTorus& torus) override {
        add("CIRCLE", torus, Transform(), {{"radius", torus.getTorusRadius() * getScale(torus)[0]}});
    }
    void implementConeGeometry(const SimTK::DecorativeCone& cone) override {
        add("FRUSTUM", cone, alongZ(cone.getOrigin(), cone.getDirection()),
            {{"length", cone.getHeight()}, {"bottom", cone.getBaseRadius()}, {"top", 0}});
    }
    void implementMeshGeometry(const SimTK::DecorativeMesh& mesh) override { addMesh(mesh, mesh.getMesh()); }
    void implementMeshFileGeometry(const SimTK::DecorativeMeshFile& file) override {
        addMesh(file, file.getMesh());
    }

private:
    // Those that are not given are negative.
    static Vec3 getScale(const SimTK::DecorativeGeometry& geometry) {
        Vec3 scale = geometry.getScaleFactors();
        for (int k = 0; k < 3; ++k)
            if (scale[k] <= 0) scale[k] = 1;
        return scale;
    }

    void add(const char* shape, const SimTK::DecorativeGeometry& geometry, const Transform& X, Json values) {
        DrawnShape drawn;
        drawn.shape = shape;
        drawn.values = std::move(values);
        drawn.markers = {geometry.getTransform() * X};
        shapes.push_back(std::move(drawn));
    }

    void addEllipsoid(const SimTK::DecorativeGeometry& geometry, const Vec3& radii) {
        const Vec3 axes = 2 * radii.elementwiseMultiply(getScale(geometry));
        add("ELLIPSOID", geometry, Transform(),
            {{"xscale", axes[0]}, {"yscale", axes[1]}, {"zscale", axes[2]}});
    }

    void addLine(const SimTK::DecorativeGeometry& geometry, const Vec3& from, const Vec3& to) {
        const Vec3 scale = getScale(geometry);
        add("OUTLINE", geometry, Transform(from.elementwiseMultiply(scale)), Json::object());
        shapes.back().markers.push_back(geometry.getTransform() * Transform(to.elementwiseMultiply(scale)));
    }

    void addMesh(const SimTK::DecorativeGeometry& geometry, const SimTK::PolygonalMesh& mesh) {
        DrawnShape drawn;
        drawn.shape = "MESH";
        const Vec3 scale = getScale(geometry);
        for (int k = 0; k < mesh.getNumVertices(); ++k)
            drawn.points.push_back(geometry.getTransform() *
                                   mesh.getVertexPosition(k).elementwiseMultiply(scale));
        for (int face = 0; face < mesh.getNumFaces(); ++face)
            for (int k = 2; k < mesh.getNumVerticesForFace(face); ++k)
                drawn.faces.push_back({mesh.getFaceVertex(face, 0), mesh.getFaceVertex(face, k - 1),
                                       mesh.getFaceVertex(face, k)});
        shapes.push_back(std::move(drawn));
    }
};

}  // namespace

std::vector<DrawnShape> readDecoration(const SimTK::DecorativeGeometry& geometry) {
    DecorationReader reader;
    geometry.implementGeometry(reader);
    return reader.shapes;
}

}  // namespace jprim
