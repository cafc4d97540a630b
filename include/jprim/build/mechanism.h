// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_BUILD_MECHANISM_H_
#define JPRIM_BUILD_MECHANISM_H_

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "jprim/analysis/constraint_equations.h"
#include "jprim/base/diagnostic.h"
#include "jprim/base/units.h"
#include "jprim/dataset/dataset.h"
#include "jprim/flexible/flexible_body.h"
#include "jprim/force/expression_measure.h"
#include "jprim/force/marker_force.h"
#include "jprim/general/general_constraint.h"
#include "jprim/joint/joint.h"
#include "jprim/marker/marker.h"

/// @file
/// A dataset as a Simbody system, with the dataset's names for its pieces. Its units are kg, s and a length
/// unit of 1 m, or for mechanisms of other sizes the power of 1000 of it that suits them: see
/// Mechanism::getLengthUnit().
namespace jprim {

/// How a part hangs in the tree of Simbody's mobilizers. Parts whose joints are all equations hang on ground by a
/// Free, POINT_MASSes by a Translation.
struct Attachment {
    int parent = -1;                    ///< its place in Mechanism::getParts(); -1 is ground's own frame
    std::string mobilizer = "Free";     ///< Simbody's word
    bool reversed = false;              ///< the part carries marker J of the joint
    std::vector<std::string> elements;  ///< the JOINT or JPRIMs that the mobilizer stands for
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

class WorkIntegral;
struct BuildOptions;

/// A JPRIM or JOINT.
struct Connection {
    std::string name;  ///< "JPRIM/12"
    std::string type;  ///< "ATPOINT"
    int i = 0;         ///< marker ids
    int j = 0;
    bool inTree = false;  ///< a mobilizer is in its place
    /// Its constraint. Empty if it is in the tree; in a loop that the tree keeps in a plane only what is not
    /// redundant: an INLINE of a hinge or ball, nothing of PARALLEL_AXES, INPLANE or PLANAR.
    std::optional<Joint> joint;
};

/// A GCON, MOTION or COUPLER.
struct Equation {
    std::string name;
    GeneralConstraint constraint;
    Dimension dimension = Dimension::Angle;  ///< of its error
};

/// A load [moment, force] in Ground, at the origin of the marker it acts on. Requires Stage::Acceleration.
using LoadFunction = std::function<SimTK::SpatialVec(const SimTK::State&)>;

/// The load of an element on its markers: of a JPRIM, JOINT, GCON, MOTION or force.
struct LoadElement {
    std::string name;  ///< "JPRIM/12"
    int i = 0;         ///< marker ids; j is 0 if there is none
    int j = 0;
    LoadFunction onI;
    LoadFunction onJ;           ///< empty if there is no J
    bool isConstraint = false;  ///< its load is a reaction
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

/// A SENSOR: ends a run where it fires, if it has HALT or RETURN.
struct MechanismSensor {
    std::string name;
    ExpressionMeasure function;  ///< in the dataset's units
    double value = 0;
    double error = 0;
    SensorComparison comparison = SensorComparison::Equal;
    bool halt = false;  ///< ends the whole run, not just the command that runs
    bool ends = true;   ///< false of one without HALT and RETURN, which does nothing
};

/// A coordinate with given values at the start: IC of a JOINT, ICDISP and ICVEL of a MOTION.
struct InitialCoordinate {
    std::string name;
    Expression coordinate;
    Dimension dimension = Dimension::Length;  ///< of an angle value and value + 2 pi are the same
    std::optional<SimTK::Real> value;
    std::optional<SimTK::Real> rate;
};

/// A mechanism owns its MultibodySystem. Movable, not copyable.
class Mechanism {
public:
    /// Conversion factors of the dataset: value in the system = factor * value in the dataset.
    const UnitSystem& getUnits() const { return m_units; }
    /// The system's unit of length L [m]. Forces are then in L newtons, moments and energies in L^2 joules.
    double getLengthUnit() const { return m_lengthUnit; }
    const std::string& getTitle() const { return m_title; }
    /// Acceleration of gravity in Ground [length unit/s^2].
    const SimTK::Vec3& getGravity() const { return m_gravity; }

    const SimTK::MultibodySystem& getSystem() const { return m_bodies->system; }
    const SimTK::SimbodyMatterSubsystem& getMatter() const { return m_bodies->matter; }

    /// In the order of the dataset, ground included; flexible bodies last.
    const std::vector<MechanismPart>& getParts() const { return m_parts; }
    const std::vector<Connection>& getConnections() const { return m_connections; }
    const std::vector<Equation>& getEquations() const { return m_equations; }
    const std::vector<MarkerForce>& getForces() const { return m_forces; }
    /// Everything that puts loads on markers, constraints and forces.
    const std::vector<LoadElement>& getLoadElements() const { return m_loadElements; }
    const std::vector<InitialCoordinate>& getInitialCoordinates() const { return m_initialCoordinates; }
    const std::vector<MechanismRequest>& getRequests() const { return m_requests; }
    const std::vector<MechanismSensor>& getSensors() const { return m_sensors; }

    /// A State at the given poses of the parts, or where these do not fit a mobilizer at the nearest that do;
    /// everything at rest. (The system's default State has all coordinates zero.) Realized to Stage::Model.
    SimTK::State makeGivenState() const;
    /// Puts the parts' bodies at poses in ground, one for each of getParts(), or where these do not fit a mobilizer at
    /// the nearest that do. Requires Stage::Model.
    void fitPoses(const std::vector<SimTK::Transform>& poses, SimTK::State& state) const;
    /// The pose X_FM of a part's mobilizer that goes with the given poses, whether it can take it or not.
    SimTK::Transform calcGivenMobilizerPose(const SimTK::State& state, const MechanismPart& part) const;

    /// The same mechanism in Formulation::Constraints; nothing if it is that already.
    std::optional<Mechanism> makeWithFreeParts() const;

    /// False if something may put energy in or take it out: damping, a force without a potential, a MOTION, a GCON
    /// that depends on time or is not satisfied at rest.
    bool isConservative() const;
    /// Kinetic energy: Simbody's, and what the deformation of flexible bodies adds. Requires Stage::Velocity.
    SimTK::Real calcKineticEnergy(const SimTK::State& state) const;
    /// What stays the same along a motion: kinetic and potential energy, less the work of loads without a potential and
    /// of constraints that move with time, which integrators integrate along. Requires Stage::Velocity.
    SimTK::Real calcEnergyBalance(const SimTK::State& state) const;

    /// The marker with this id; 0 is ground's own frame. @throws Error if there is none
    const Marker& getMarker(int id) const;

    /// Adams' functions JPRIM(id, jflag, comp, rm) and JOINT(…) [N, N m]; rm = 0 means ground's axes.
    /// Requires Stage::Acceleration. @throws Error if id or rm does not exist
    SimTK::Real calcJPRIM(const SimTK::State& state, int id, int jflag, int comp, int rm = 0) const;
    SimTK::Real calcJOINT(const SimTK::State& state, int id, int jflag, int comp, int rm = 0) const;

    /// The elements that can be switched off and on, "JPRIM/3", and the constraint that each is.
    std::vector<std::string> getSwitchableElements() const;
    SimTK::Constraint getConstraint(const std::string& element) const;

    /// What the constraints are called in a diagnosis: "JOINT/3 REVOLUTE" and what each equation holds.
    ElementNames getElementNames() const;

    /// The constraint equations in use by element, "JOINT/3", as Simbody numbers them: those of positions first
    /// (getQErr()), then those of velocities, then those of accelerations. Requires Stage::Instance.
    std::vector<ConstraintEquation> findEquations(const SimTK::State& state) const;

private:
    friend class MechanismBuilder;
    friend std::optional<Mechanism> buildMechanism(const Dataset& dataset, Diagnostics& diagnostics,
                                                   const BuildOptions& options);

    struct Bodies {
        SimTK::MultibodySystem system;
        SimTK::SimbodyMatterSubsystem matter{system};
        SimTK::GeneralForceSubsystem forces{system};
    };

    Mechanism();
    SimTK::Real calcReaction(const SimTK::State& state, const std::string& name, int jflag, int comp,
                             int rm) const;

    std::string m_title;
    UnitSystem m_units;
    double m_lengthUnit = 1;
    SimTK::Vec3 m_gravity{0};
    std::unique_ptr<Bodies> m_bodies;
    std::vector<MechanismPart> m_parts;
    std::unordered_map<int, Marker> m_markers;
    std::vector<Connection> m_connections;
    std::unordered_map<std::string, size_t> m_connectionLoad;  // its place among the load elements
    std::vector<Equation> m_equations;
    std::vector<MarkerForce> m_forces;
    std::vector<LoadElement> m_loadElements;
    std::vector<InitialCoordinate> m_initialCoordinates;
    std::vector<MechanismRequest> m_requests;
    std::vector<MechanismSensor> m_sensors;
    std::function<Mechanism()> m_makeWithFreeParts;  // empty if the parts are free
    bool m_hasPower = false;                         // an element may change the energy
    const WorkIntegral* m_work = nullptr;  // owned by the system; null if the mechanism is conservative
};

}  // namespace jprim

#endif
