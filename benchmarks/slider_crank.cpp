// SPDX-License-Identifier: Apache-2.0
#include "slider_crank.h"

#include <unistd.h>

#include <filesystem>
#include <string>

#include "base/format.h"
#include "runs.h"

namespace jprim::benchmarks {

const ModalBasis& getRodBasis() {
    constexpr int FixedInterfaceModes = 14;  // and 6 of the interfaces
    static const ModalBasis basis = [] {
        UniformBeam beam;
        beam.length = RodLength;
        beam.elements = RodEnd - 1;
        beam.youngsModulus = 7e10;
        beam.shearModulus = 2.6e10;
        beam.density = 2700;
        beam.area = 2e-4;
        beam.secondMomentY = 6.7e-9;
        beam.secondMomentZ = 1.7e-9;
        beam.torsionConstant = 4.6e-9;
        return reduceToModes(makeFiniteElementModel(beam), {{{1}, 0, {}}, {{RodEnd}, 0, {}}},
                             FixedInterfaceModes);
    }();
    return basis;
}

namespace {

std::string writeSliderCrank(const std::string& modesFile) {
    const double end = CrankRadius + RodLength;
    const double rodTurn = -CrankSpeed * CrankRadius / RodLength;
    const std::string light = fmt::format("MASS={0},IP={1},{1},{1}", SmallMass, SmallInertia);
    return fmt::format(
               "slider-crank\nPART/1,GROUND\nMARKER/1\nMARKER/2,QP={},0,0,REULER=90D,90D,0\n"
               "PART/2,{},CM=20,WZ={}\nMARKER/20\nMARKER/21,QP={},0,0\n",
               end, light, CrankSpeed, CrankRadius) +
           fmt::format(
               "FLEX_BODY/3,MODES_FILE='{}',QG={},0,0,VX=0,VY={},WZ={}\n"
               "MARKER/30,NODE_ID=1\nMARKER/31,NODE_ID={}\nMARKER/32,NODE_ID={}\n",
               modesFile, CrankRadius, CrankSpeed * CrankRadius / 2, rodTurn, RodEnd, (RodEnd + 1) / 2) +
           fmt::format("PART/4,{},CM=40,QG={},0,0\nMARKER/40\nMARKER/41,REULER=90D,90D,0\n", light, end) +
           fmt::format(
               "JOINT/1,REVOLUTE,I=20,J=1\nJOINT/2,REVOLUTE,I=30,J=21\nJOINT/3,TRANSLATIONAL,I=41,J=2\n"
               "JPRIM/4,INLINE,I=31,J=40\nMOTION/5,JOINT=1,ROTATIONAL,FUNCTION={}*TIME\nEND\n",
               CrankSpeed);
}

}  // namespace

Mechanism buildSliderCrank() {
    const std::string modes =
        (std::filesystem::temp_directory_path() / fmt::format("jprim_rod_{}.modes", getpid())).string();
    saveModalBasis(getRodBasis(), modes);
    Mechanism mechanism = buildFromText(writeSliderCrank(modes));
    std::filesystem::remove(modes);
    return mechanism;
}

}  // namespace jprim::benchmarks
