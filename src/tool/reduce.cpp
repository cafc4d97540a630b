// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"
#include "jprim/base/units.h"
#include "jprim/flexible/read_mesh.h"
#include "jprim/flexible/reduce_to_modes.h"
#include "tool/commands.h"

namespace jprim::tool {

namespace {

void printWarning(const std::string& message) {
    fmt::print(stderr, "warning: {}\n", message);
}

void printWarnings(const std::vector<std::string>& warnings) {
    constexpr std::size_t most = 20;
    for (std::size_t k = 0; k < std::min(most, warnings.size()); ++k) printWarning(warnings[k]);
    if (warnings.size() > most)
        printWarning(fmt::format("there are {} more of these", warnings.size() - most));
}

// The square of the speed at which a change of volume travels, bulk modulus over density: blown up by the
// displacement u = p, a mesh of any shape and elements stores the energy 9 K V / 2.
double calcSquaredSpeedOfSound(const FiniteElementModel& model) {
    const auto getCoordinate = [&model](int freedom) {
        return model.nodes[std::size_t(freedom / 3)].position[freedom % 3] -
               model.nodes[0].position[freedom % 3];
    };
    double blownUp = 0, mass = 0;
    for (const MatrixTerm& t : model.stiffness)
        blownUp += getCoordinate(t.row) * t.value * getCoordinate(t.column);
    for (const MatrixTerm& t : model.mass)
        if (t.row % 3 == t.column % 3) mass += t.value / 3;
    return blownUp / (9 * mass);
}

// A mesh in mm taken for one in m is a thousand times too stiff for its mass, whatever its size and its unit of
// mass. Diamond has 11 km/s, rubber foam in mm a hundred.
void warnOfLength(const ReduceArguments& arguments, const FiniteElementMesh& mesh) {
    constexpr double Fastest = 5e4;
    const double speed = std::sqrt(calcSquaredSpeedOfSound(mesh.model));
    if (arguments.lengthUnit || !(speed > Fastest)) return;
    printWarning(
        fmt::format("{}: read in metres, sound would travel through this mesh at {:.2g} m/s, faster than in "
                    "any material; give --length MILLIMETER (and --mass TONNE) for a mesh in mm, or --length "
                    "METER if it is right",
                    mesh.model.name, speed));
}

void printModes(const ReduceArguments& arguments, const std::vector<InterfacePoint>& points,
                const ModalBasis& basis) {
    constexpr double RadiansPerTurn = 6.283185307179586;
    fmt::print("nodes                    {}\n", basis.nodes.size());
    fmt::print("mass                     {:.9g} kg\n", basis.rigid.mass);
    fmt::print("mass centre              {:.9g} {:.9g} {:.9g} m\n", basis.rigid.center[0],
               basis.rigid.center[1], basis.rigid.center[2]);
    for (std::size_t k = 0; k < points.size(); ++k)
        fmt::print("interface {:<14} node {}, which moves {} nodes\n", points[k].name, basis.interfaces[k],
                   points[k].nodes.size());
    for (int k = 0; k < basis.getNumModes(); ++k)
        fmt::print("mode {:<4}                {:.6g} Hz\n", k + 1,
                   basis.frequencies[std::size_t(k)] / RadiansPerTurn);
    fmt::print("modes written to         {}\n", arguments.out);
}

std::vector<InterfacePoint> findInterfaces(const ReduceArguments& arguments, const FiniteElementMesh& mesh) {
    std::vector<InterfacePoint> points;
    for (const std::string& set : arguments.interfaces)
        points.push_back({mesh.getNodeSet(set), 0, std::nullopt, set});
    return points;
}

}  // namespace

ExitCode reduce(const ReduceArguments& arguments) {
    ExitCode failure = DatasetHasErrors;
    try {
        const FiniteElementMesh mesh =
            arguments.matrices.empty()
                ? readCalculixMesh(arguments.mesh)
                : readAbaqusMesh(arguments.mesh, arguments.matrices[0], arguments.matrices[1]);
        printWarnings(mesh.warnings);
        const std::vector<InterfacePoint> points = findInterfaces(arguments, mesh);
        const double length = findUnit(Quantity::Length, arguments.lengthUnit.value_or("METER")).value().inSI;
        const double mass = findUnit(Quantity::Mass, arguments.massUnit).value().inSI;
        const ModalBasis basis = convertUnits(reduceToModes(mesh, points, arguments.modes), length, mass, 1);
        warnOfLength(arguments, mesh);
        failure = SimulationFailed;
        saveModalBasis(basis, arguments.out);
        printModes(arguments, points, basis);
    } catch (const Error& error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return failure;
    }
    return Done;
}

}  // namespace jprim::tool
