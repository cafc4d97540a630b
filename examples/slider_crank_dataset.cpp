// SPDX-License-Identifier: Apache-2.0
// From the text of a dataset to results: each step is one function and leaves a value to look at.
//
//     text -> Dataset -> Mechanism -> AssembledState -> Results
//         read       build        assemble       simulate
//
// The dataset is slider_crank.adm, in mm-kg-N-s: the mechanism of slider_crank.cpp with a crank that starts
// at 6 rad/s and revolves under gravity for 2 s.
//
// Expected (exact_slider_crank.h): at every output time, with phi the crank angle that is reached,
//     slider position  x = r cos phi + sqrt(l^2 - r^2 sin^2 phi)
//     crank speed      phi_dot from energy conservation
//     force of the guide on the slider  N = m (g + x_ddot tan theta), m the slider and half the rod
// The numbers printed are those of the output time at which the simulated one is farthest from the exact one.
#include <jprim/jprim.h>

#include <vector>

#include "compare.h"
#include "exact_slider_crank.h"

using namespace SimTK;

// As compare.h reads it. The integrator's accuracy, 1e-6 per step, adds up over the run.
const Real Tolerance = 1e-4;

struct Comparison {
    Real simulated, exact;
};

// A NaN is the worst of all and stays.
void keepWorst(Comparison& worst, Real simulated, Real exact) {
    const Real difference = std::abs(simulated - exact);
    if (isNaN(difference) || difference > std::abs(worst.simulated - worst.exact)) worst = {simulated, exact};
}

int main(int argc, char** argv) {
    const std::string file = argc > 1 ? argv[1] : "slider_crank.adm";

    jprim::Diagnostics diagnostics;
    const jprim::Dataset dataset = jprim::readDatasetFile(file, diagnostics);
    std::optional<jprim::Mechanism> mechanism;
    if (!jprim::hasErrors(diagnostics)) mechanism = jprim::buildMechanism(dataset, diagnostics);
    for (const jprim::Diagnostic& d : diagnostics) std::puts(jprim::formatDiagnostic(file, d).c_str());
    if (!mechanism) return 1;

    const jprim::AssembledState initial = jprim::assemble(*mechanism);

    jprim::SimulationOptions options;
    options.end = 2;  // s
    options.steps = 400;
    const jprim::SimulationOutcome outcome = jprim::simulate(*mechanism, initial, options);
    if (!outcome.failure.empty()) std::puts(outcome.failure.c_str());

    ExactSliderCrank exact;
    exact.phiDot0 = 6;                             // rad/s
    const Real mm = mechanism->getUnits().length;  // 1e-3 m
    const jprim::Table& requests = outcome.results.requests;
    const std::vector<double> sliderX = requests.getColumn("R1.X"), pinX = requests.getColumn("R3.X"),
                              pinY = requests.getColumn("R3.Y"), crankSpeed = requests.getColumn("R4.WZ"),
                              guideForce = requests.getColumn("R5.FY");
    Comparison x{}, speed{}, force{};
    for (size_t row = 0; row < requests.getNumRows(); ++row) {
        const Real phi = std::atan2(pinY[row], pinX[row]);
        keepWorst(x, sliderX[row], exact.getX(phi) / mm);
        keepWorst(speed, crankSpeed[row], exact.getSpeed(phi));
        keepWorst(force, guideForce[row], exact.getGuideForce(phi));
    }
    bool agree = outcome.failure.empty() && requests.getNumRows() == 401;
    agree &= compare("slider position [mm]", x.simulated, x.exact, Tolerance);
    agree &= compare("crank speed [rad/s]", speed.simulated, speed.exact, Tolerance);
    agree &= compare("force of the guide on the slider [N]", force.simulated, force.exact, Tolerance);
    return agree ? 0 : 1;
}
