// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SIMULATION_SIMULATE_H_
#define JPRIM_SIMULATION_SIMULATE_H_

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jprim/results/results.h"
#include "jprim/simulation/assemble.h"

namespace jprim {

/// How to go on in time. Automatic: kinematics where nothing is free to move and all constraints are on
/// positions, else dynamics. Statics: an equilibrium at each output time.
enum class SimulationKind { Automatic, Dynamics, Kinematics, Statics };

/// What becomes of equations that follow from others. Share: they stay, and Simbody's least-norm multipliers
/// spread the load over all of them; only where no motion changes any of positions, these are dropped. Drop: as in Adams the
/// later ones are switched off and carry nothing; where those that are kept become dependent, others are chosen.
enum class Redundancy { Share, Drop };

/// What a SENSOR does when it is true. Armed: it fires. Fired: it has fired, and is armed again by a step at whose end
/// it is false. Off: nothing.
enum class SensorState { Armed, Fired, Off };

/// More are a mistake of units, as a rule.
constexpr int MostOutputSteps = 10000000;

struct SimulationOptions {
    Redundancy redundancy = Redundancy::Share;
    SimulationKind kind = SimulationKind::Automatic;
    double end = 0;  ///< end time, in the dataset's unit; it starts at the time of the initial state
    /// Output steps of equal length, at most MostOutputSteps; steps + 1 rows are recorded. With 0 steps only the initial state is.
    int steps = 100;
    /// In place of steps, unless there are none: the length of an output step, in the dataset's unit. The end is recorded
    /// too, after a shorter step if the length does not divide the run.
    std::optional<double> outputStep;
    std::vector<SensorState> sensors;  ///< in the order of Mechanism::getSensors(); what is missing is Armed
    /// Relative, of the integrator: errors of a step are held against how far and how fast a part has moved so far.
    double accuracy = 1e-6;
    /// What the root mean square of constraint errors may be, in the mechanism's length unit and radians; a tenth of
    /// the accuracy if not given.
    std::optional<double> constraintTolerance;
    double maximumStep = SimTK::Infinity;         ///< of the integrator, in the dataset's unit of time
    std::string integrator = "RungeKuttaMerson";  ///< one of getIntegratorNames()
    /// Called with the finished fraction, 0 to 1, after each output step. If it throws, the simulation ends
    /// there as if it had failed.
    std::function<void(double)> reportProgress;

    double getConstraintTolerance() const { return constraintTolerance.value_or(accuracy / 10); }
};

/// The integrators of Simbody that can be named.
std::vector<std::string> getIntegratorNames();

/// Other equations than before, from a moment on at which those that were kept became nearly dependent.
struct DroppedAnew {
    double time = 0;                     ///< in the dataset's unit
    std::vector<std::string> equations;  ///< in words
};

/// A value of a request that is infinite or no number, such as the root of a negative one.
struct NotFinite {
    std::string request;  ///< "REQUEST/3"
    std::string column;   ///< of Results::requests
    double value = 0;
    double time = 0;  ///< in the dataset's unit
};

/// How a simulation went, in the mechanism's units.
struct SimulationSummary {
    int degreesOfFreedom = 0;                   ///< at the start
    int redundantEquations = 0;                 ///< at the start
    std::vector<std::string> droppedEquations;  ///< in words, at the start
    std::vector<DroppedAnew> droppedAnew;       ///< with Redundancy::Drop
    Violation worstViolation;                   ///< over all recorded times
    double energyAtStart = 0;
    double energyAtEnd = 0;
    double largestEnergyChange = 0;  ///< over all steps, from the start
    /// Over all integrated steps, of Mechanism::calcEnergyBalance(): energy that has come from nowhere or is lost.
    double largestImbalance = 0;
    /// What that may be without a warning: five thousandths of energyScale or of largestEnergyChange, or if more a
    /// thousandth of the largest kinetic energy or of all the energy that went in and out, whatever its sign. Motions that
    /// are right to a thousandth have less.
    double tolerableImbalance = 0;
    /// What changes are held against: largest less smallest kinetic energy; 1e-3 of the largest if it hardly
    /// changes, and where hardly anything moves 4e-13 of the work of weights and forces over heights and parts' sizes,
    /// and the energy at 1e-9 length units/s.
    double energyScale = 0;
    bool isKinematic = false;  ///< nothing was integrated: positions followed from the constraints
    int stepsTaken = 0;        ///< of the integrator or the kinematic solution
    std::string endedBy;       ///< the sensor that ended it before its time: "SENSOR/3"; empty if none
    bool isHalted = false;     ///< and that sensor has HALT
    std::vector<NotFinite> notFinite;  ///< the first of each request that has any
    double wallSeconds = 0;
};

/// What a simulation leaves behind. If it failed, `failure` names the time and the element and the results
/// end there; it is empty otherwise.
struct SimulationOutcome {
    Results results;
    SimulationSummary summary;
    SimTK::State finalState;
    std::vector<SensorState> sensors;  ///< at the end, in the order of Mechanism::getSensors()
    std::string failure;
};

/// Moves a mechanism on from assembled initial conditions and records it at its output times. Every output time
/// ends a step: nothing recorded is interpolated. A sensor ends the run at the moment it fires.
/// @throws Error if an option is out of range, or kinematics are asked for and impossible
SimulationOutcome simulate(const Mechanism& mechanism, const AssembledState& initial,
                           const SimulationOptions& options);
/// The same with results that go elsewhere: SimulationOutcome::results stay empty.
SimulationOutcome simulate(const Mechanism& mechanism, const AssembledState& initial,
                           const SimulationOptions& options, ResultSink& sink);

}  // namespace jprim

#endif
