// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "jprim/base/units.h"
#include "jprim/flexible/read_mesh.h"
#include "jprim/flexible/reduce_to_modes.h"
#include "tool/commands.h"

namespace jprim::tool {

namespace {

void printModes(const ReduceArguments& arguments, const ModalBasis& basis) {
    constexpr double RadiansPerTurn = 6.283185307179586;
    fmt::print("nodes                    {}\n", basis.nodes.size());
    fmt::print("mass                     {:.9g} kg\n", basis.rigid.mass);
    fmt::print("mass centre              {:.9g} {:.9g} {:.9g} m\n", basis.rigid.center[0],
               basis.rigid.center[1], basis.rigid.center[2]);
    for (size_t k = 0; k < arguments.interfaces.size(); ++k)
        fmt::print("interface {:<14} node {}\n", arguments.interfaces[k], basis.interfaces[k]);
    for (int k = 0; k < basis.getNumModes(); ++k)
        fmt::print("mode {:<4}                {:.6g} Hz\n", k + 1, basis.frequencies[k] / RadiansPerTurn);
    fmt::print("modes written to         {}\n", arguments.out);
}

}  // namespace

ExitCode reduce(const ReduceArguments& arguments) {
    try {
        const FiniteElementMesh mesh =
            arguments.matrices.empty()
                ? readCalculixMesh(arguments.mesh)
                : readAbaqusMesh(arguments.mesh, arguments.matrices[0], arguments.matrices[1]);
        std::vector<InterfacePoint> points;
        for (const std::string& set : arguments.interfaces)
            points.push_back({mesh.getNodeSet(set), 0, std::nullopt});
        const ModalBasis basis = convertUnits(reduceToModes(mesh.model, points, arguments.modes),
                                              findUnit(Quantity::Length, arguments.lengthUnit).value().inSI,
                                              findUnit(Quantity::Mass, arguments.massUnit).value().inSI, 1);
        saveModalBasis(basis, arguments.out);
        printModes(arguments, basis);
    } catch (const std::exception& error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return DatasetHasErrors;
    }
    return Done;
}

}  // namespace jprim::tool
