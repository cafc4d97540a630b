// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_MECHANISM_MECHANISM_H_
#define JPRIM_MECHANISM_MECHANISM_H_

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jprim/analysis/constraint_equations.h"
#include "jprim/base/diagnostic.h"
#include "jprim/base/units.h"
#include "jprim/dataset/dataset.h"
#include "jprim/flexible/flexible_body.h"
#include "jprim/force/expression_measure.h"
#include "jprim/marker/marker.h"
#include "jprim/mechanism/element.h"

/// @file
/// A dataset as a Simbody system, with the dataset's names for its pieces. Its units are kg, s and a length
/// unit of 1 m, or for mechanisms of other sizes the power of 1000 of it that suits them: see
/// Mechanism::getLengthUnit().
namespace jprim {

/// How a part hangs in the tree of Simbody's mobilizers. Parts whose joints are all equations hang on ground by a
/// Free, POINT_MASSes by a Translation.
struct Attachment {
    int parent = -1;                  ///< its place in Mechanism::getParts(); -1 is ground's own frame
    std::string mobilizer = "Free";   ///< Simbody's word
    bool reversed = false;            ///< the part carries marker J of the joint
    std::vector<ElementId> elements;  ///< the JOINT or JPRIMs that the mobilizer stands for
};

/// A PART, POINT_MASS or FLEX_BODY. Its body's frame has its origin at the mass centre and the axes of the part's body
/// coordinate system (BCS), which for a FLEX_BODY are the mean axes of the deformation.
struct MechanismPart {
    std::string name;  ///< "PART/3", "FLEX_BODY/3"
    SimTK::MobilizedBody body;
    Attachment attachment;
    bool ground = false;
    bool turns = true;                     ///< false for a POINT_MASS, which has no rotations
    std::optional<FlexibleBody> flexible;  ///< of a FLEX_BODY
    /// The part's body coordinate system.
    Marker bcs;
    /// The CM marker; on ground the BCS, on a FLEX_BODY the mass centre with the axes of the BCS.
    Marker cm;
    /// The given pose of the BCS in ground, and which of its coordinates assembly must not move; none of
    /// ground's.
    SimTK::Transform givenPose;
    std::array<bool, 6> exact{};
    /// The given velocity of the mass centre along the axes of vm [length unit/s], and the given angular
    /// velocity about the axes of wm [rad/s]; empty components are free.
    std::array<std::optional<SimTK::Real>, 3> v, w;
    Marker vm, wm;
    /// Largest distance of a marker or node from the mass centre [length unit]: what turns an angle into a
    /// displacement.
    SimTK::Real size = 1;

    /// The pose of the Simbody body in ground that goes with givenPose.
    SimTK::Transform calcGivenBodyPose() const { return givenPose * ~bcs.getPose(); }
};

/// A REQUEST that can be evaluated.
struct MechanismRequest {
    int id = 0;
    std::string resultsName;          ///< what results call it, if not "R7"
    std::vector<std::string> cnames;  ///< and its eight components; an empty name stands for the usual one
    RequestType type = RequestType::Displacement;
    Marker I;
    Marker J;                         ///< on ground if the dataset names none
    Marker rm;                        ///< ground's frame if the dataset names none
    std::vector<LoadFunction> loads;  ///< FORCE: of the elements between I and J, on I
    /// The number of a column and its function, in the dataset's units: (2, …) for F2=….
    std::vector<std::pair<int, ExpressionMeasure>> functions;
};

/// A state of a DIFF, LSE or TFSISO. The k-th of Mechanism::getStates() is the k-th of a State's z, in the dataset's
/// units; integrators hold its errors against how large it has been.
struct MechanismState {
    std::string name;         ///< "DIFF/3", "LSE/2 state 1"
    ExpressionMeasure rate;   ///< its derivative, per the dataset's unit of time
    bool staticHold = false;  ///< statics leave it what it is, instead of making its derivative zero
};

/// A SENSOR: ends a run where it fires, if it has HALT or RETURN, and notes what EVALUATE says.
struct MechanismSensor {
    ElementId id;
    ExpressionMeasure function;  ///< in the dataset's units
    double value = 0;
    double error = 0;
    SensorComparison comparison = SensorComparison::Equal;
    bool halt = false;                          ///< ends the whole run, not just the command that runs
    bool ends = true;                           ///< false of one without HALT and RETURN
    std::optional<ExpressionMeasure> evaluate;  ///< what SENVAL is from where it fires

    /// False if it does nothing where it fires.
    [[nodiscard]] bool acts() const { return ends || evaluate; }
};

/// A coordinate with given values at the start: IC of a JOINT, ICDISP and ICVEL of a MOTION.
struct InitialCoordinate {
    ElementId element;
    Expression coordinate;
    Dimension dimension = Dimension::Length;  ///< of an angle value and value + 2 pi are the same
    std::optional<SimTK::Real> value;
    std::optional<SimTK::Real> rate;
};

struct MechanismContents;

/// A mechanism owns its MultibodySystem. Movable, not copyable.
class Mechanism {
public:
    /// For buildMechanism().
    explicit Mechanism(std::unique_ptr<const MechanismContents> contents);
    Mechanism(Mechanism&&) noexcept;
    Mechanism& operator=(Mechanism&&) noexcept;
    ~Mechanism();

    /// Conversion factors of the dataset: value in the system = factor * value in the dataset.
    [[nodiscard]] const UnitSystem& getUnits() const;
    /// The system's unit of length L [m]. Forces are then in L newtons, moments and energies in L^2 joules.
    [[nodiscard]] double getLengthUnit() const;
    [[nodiscard]] const std::string& getTitle() const;
    /// Acceleration of gravity in Ground [length unit/s^2].
    [[nodiscard]] const SimTK::Vec3& getGravity() const;

    [[nodiscard]] const SimTK::MultibodySystem& getSystem() const;
    [[nodiscard]] const SimTK::SimbodyMatterSubsystem& getMatter() const;

    /// In the order of the dataset, ground included; flexible bodies last.
    [[nodiscard]] const std::vector<MechanismPart>& getParts() const;
    /// Everything that acts between markers: JPRIMs, JOINTs, GCONs, MOTIONs, COUPLERs, then forces; each kind in the
    /// order of the dataset.
    [[nodiscard]] const ElementList& getElements() const;
    /// @throws Error if it does not exist
    [[nodiscard]] const Element& getElement(const ElementId& id) const;
    [[nodiscard]] const std::vector<InitialCoordinate>& getInitialCoordinates() const;
    [[nodiscard]] const std::vector<MechanismRequest>& getRequests() const;
    [[nodiscard]] const std::vector<MechanismSensor>& getSensors() const;
    [[nodiscard]] const std::vector<MechanismState>& getStates() const;
    /// What SENVAL gives for the k-th of getSensors(), if that has EVALUATE: 0 before it fires, then what is set.
    [[nodiscard]] SimTK::Real getSensorValue(const SimTK::State& state, std::size_t k) const;
    void setSensorValue(SimTK::State& state, std::size_t k, SimTK::Real value) const;
    /// The marker with this id; 0 is ground's own frame. @throws Error if there is none
    [[nodiscard]] const Marker& getMarker(int id) const;

    /// A State at the given poses of the parts, or where these do not fit a mobilizer at the nearest that do;
    /// everything at rest. (The system's default State has all coordinates zero.) Realized to Stage::Model.
    [[nodiscard]] SimTK::State makeGivenState() const;
    /// Puts the parts' bodies at poses in ground, one for each of getParts(), or where these do not fit a mobilizer at
    /// the nearest that do. Requires Stage::Model.
    void fitPoses(const std::vector<SimTK::Transform>& poses, SimTK::State& state) const;
    /// The pose X_FM of a part's mobilizer that goes with the given poses, whether it can take it or not.
    [[nodiscard]] SimTK::Transform calcGivenMobilizerPose(const SimTK::State& state,
                                                          const MechanismPart& part) const;

    /// The same mechanism in Formulation::Constraints; nothing if it is that already.
    [[nodiscard]] std::optional<Mechanism> makeWithFreeParts() const;

    /// False if something may put energy in or take it out: damping, a force without a potential, a MOTION, a GCON
    /// that depends on time or is not satisfied at rest.
    [[nodiscard]] bool isConservative() const;
    /// Kinetic energy: Simbody's, and what the deformation of flexible bodies adds. Requires Stage::Velocity.
    [[nodiscard]] SimTK::Real calcKineticEnergy(const SimTK::State& state) const;
    /// What stays the same along a motion: kinetic and potential energy, less the work of loads without a potential and
    /// of constraints that move with time, which integrators integrate along. Requires Stage::Velocity.
    [[nodiscard]] SimTK::Real calcEnergyBalance(const SimTK::State& state) const;

    /// Adams' functions JPRIM(id, jflag, comp, rm) and JOINT(…) [N, N m]; rm = 0 means ground's axes.
    /// Requires Stage::Acceleration. @throws Error if id or rm does not exist
    [[nodiscard]] SimTK::Real calcJPRIM(const SimTK::State& state, int id, int jflag, int comp,
                                        int rm = 0) const;
    [[nodiscard]] SimTK::Real calcJOINT(const SimTK::State& state, int id, int jflag, int comp,
                                        int rm = 0) const;

    /// What the constraints are called in a diagnosis: "JOINT/3 REVOLUTE" and what each equation holds.
    [[nodiscard]] ElementNames getElementNames() const;

    /// The constraint equations in use by element, "JOINT/3", as Simbody numbers them: those of positions first
    /// (getQErr()), then those of velocities, then those of accelerations. Requires Stage::Instance.
    [[nodiscard]] std::vector<ConstraintEquation> findEquations(const SimTK::State& state) const;

private:
    SimTK::Real calcReaction(const SimTK::State& state, const ElementId& id, int jflag, int comp,
                             int rm) const;

    std::unique_ptr<const MechanismContents> m_contents;
};

}  // namespace jprim

#endif
