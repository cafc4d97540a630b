// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BUILD_MECHANISM_BUILDER_H_
#define JPRIM_SRC_BUILD_MECHANISM_BUILDER_H_

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/sort_diagnostics.h"
#include "build/function_writer.h"
#include "build/load_modes.h"
#include "build/part_mass.h"
#include "build/planar_loops.h"
#include "build/tree_plan.h"
#include "jprim/base/diagnostic.h"
#include "jprim/base/error.h"
#include "jprim/build/build_mechanism.h"
#include "jprim/joint/motion.h"

namespace jprim {

/// One pass over the dataset in the order in which things need each other: units, modes, marker poses,
/// gravity, parts, markers, functions, constraints, forces, requests.
class MechanismBuilder {
public:
    MechanismBuilder(const Dataset& dataset, Diagnostics& diagnostics, const BuildOptions& options)
        : m_dataset(dataset),
          m_diagnostics(diagnostics),
          m_plan(options.formulation == Formulation::Tree ? planTree(dataset) : planFreeParts(dataset)),
          m_planarLoops(
              m_plan, [this](int marker) { return getMarkerPose(marker); },
              [this](int marker) { return m_ownerOfMarker.at(marker); }) {}

    std::optional<Mechanism> build() {
        const size_t earlier = m_diagnostics.size();
        m_mechanism.m_title = m_dataset.title;
        addBodies();
        if (m_mechanism.m_parts.size() == m_numParts) addElements();
        sortByPosition(earlier, m_diagnostics);
        if (m_failed) return std::nullopt;
        return std::move(m_mechanism);
    }

private:
    // A mistake is noted and what it concerns is built in some way, so that all mistakes are found. Only a flexible
    // body without its modes cannot be, and then nothing is there for what stands on it.
    void addBodies() {
        chooseUnits();
        indexParts();
        m_modes = loadModes(m_dataset, [this](const SourcePosition& where, const std::string& message) {
            report(Severity::Error, where, message);
        });
        findMarkerPoses();
        chooseLengthUnit();
        addGravity();
        addParts();
        addPointMasses();
        addFlexBodies();
    }

    void addElements() {
        addMarkers();
        checkAxes();
        prepareFunctions();
        addConnections();
        addEquations();
        addForces();
        if (!m_failed) addWorkIntegral();
        checkVariables();
        addRequests();
        addSensors();
        if (!m_failed) checkNegativeMoments();
    }

    /// A part with a negative principal moment of inertia: whether that matters shows when all constraints are there.
    struct NegativeMoment {
        const PartStatement* statement;
        SimTK::Mat33 inertia;  ///< about the mass centre
        SimTK::Real moment;    ///< the smallest
        std::string oddities;  ///< what else is to be said of it
    };

    /// Where an element is that a mobilizer stands for.
    struct TreePlace {
        const PlannedMobilizer* mobilizer;
        const PlannedElement* element;
    };

    void report(Severity severity, const SourcePosition& where, const std::string& message) {
        m_failed = m_failed || severity == Severity::Error;
        m_diagnostics.push_back({severity, where, message});
    }

    void reportFrame(const std::string& name, const SourcePosition& where, const std::string& problem) {
        m_undefined.insert(name);
        report(Severity::Error, where, name + ": " + problem);
    }

    void chooseUnits();
    void applyUcf(const UnitsStatement& statement);
    void indexParts();
    void findMarkerPoses();
    std::optional<Triple> findOrigin(const MarkerStatement& marker);
    void chooseLengthUnit();
    void addGravity();
    void addParts();
    void addGround();
    void addPart(const PlannedMobilizer& planned);
    void addBody(const PlannedMobilizer& planned, const SimTK::Body& body, const SimTK::Transform& X_BP,
                 MechanismPart& part);
    void addFlexBodies();
    void addFlexBody(const FlexBodyStatement& statement);
    void setRigidCoordinates(const RigidCoordinates& statement, const SourcePosition& where,
                             MechanismPart& part);
    void checkGround(const PartStatement& statement);
    SolvableMass chooseMass(const PartStatement& statement, const SimTK::Transform& X_PC, SimTK::Real size);
    void checkNegativeMoments();
    void addMarkers();
    Marker makeMarker(const MarkerStatement& statement) const;
    void checkAxes();
    void addPointMasses();
    void addPointMass(const PointMassStatement& statement);
    void prepareFunctions();
    void addConnections();
    template <class Statement, class Make>
    void addConnection(const char* keyword, const Statement& statement, const Make& makeEquations);
    static LoadElement makeLoad(const Connection& connection);
    LoadElement makeTreeLoad(int i, int j, const TreePlace& place) const;
    Joint makeJoint(const JointStatement& statement, const std::string& name) const;
    void addEquations();
    void addEquation(const std::string& name, GeneralConstraint constraint, const Expression& f);
    void addGcon(const GconStatement& statement);
    void addMotion(const MotionStatement& statement);
    void addCoupler(const CouplerStatement& statement);
    void addInitialCoordinates(const JointStatement& statement);
    void addInitialCoordinate(const std::string& name, int i, int j, Coordinate coordinate,
                              const std::optional<double>& value, const std::optional<double>& rate);
    void addForces();
    void addForce(const std::string& name, int i, int j, const ForceLaw& law);
    void addSforce(const SforceStatement& statement);
    void addVectorForce(const VectorForceStatement& statement);
    void addSpringdamper(const SpringdamperStatement& statement);
    void addBushing(const BushingStatement& statement);
    void checkVariables();
    void addLoadElement(const LoadElement& element);
    ExpressionMeasure makeMeasure(const ExpressionText& function);
    void addWorkIntegral();
    void addRequests();
    void addSensors();

    /// Builds an element; a mistake in it is reported at its function or statement.
    template <class Build>
    void attempt(const std::string& element, const SourcePosition& where, const Build& build) {
        try {
            return build();
        } catch (const FunctionError& error) {
            report(Severity::Error, error.where, element + ": " + error.what());
        } catch (const Error& error) {
            report(Severity::Error, where, error.what());
        } catch (const std::exception& error) {  // Simbody's, which runs over several lines
            std::string text = error.what();
            std::replace(text.begin(), text.end(), '\n', ' ');
            report(Severity::Error, where, element + ": " + text);
        }
        m_functions.addUnknownLoad(element);
    }

    /// An expression of functions of the dataset. @throws FunctionError
    template <class Compose>
    Expression write(FunctionUse use, const Compose& compose) {
        const MarkerFrames::FindMarker find = [this](int id) { return findFixedMarker(id); };
        FunctionWriter writer(find, m_functions, use);
        return writer.finish(compose(writer));
    }

    const Marker* findFixedMarker(int id) const;
    /// Unit of a force, or of a moment.
    SimTK::Real getForceUnit(bool isMoment) const {
        return isMoment ? m_mechanism.m_units.getMoment() : m_mechanism.m_units.force;
    }
    SimTK::Transform getGivenPose(int marker) const;
    bool hasGivenPose(int marker) const;
    SimTK::Transform getMarkerPose(int id) const {
        return id == 0 ? SimTK::Transform() : m_markerPoses.at(id);
    }
    SimTK::Real calcReach(int owner, const SimTK::Vec3& center) const;

    const Dataset& m_dataset;
    Diagnostics& m_diagnostics;
    const TreePlan m_plan;
    const PlanarLoops m_planarLoops;
    bool m_failed = false;
    size_t m_numParts = 0;                        // how many parts there are to be
    std::unordered_set<std::string> m_undefined;  // parts and markers whose axes are not defined
    Mechanism m_mechanism;
    std::unordered_map<int, SimTK::Transform> m_markerPoses;  // in the part's BCS, undeformed
    // Parts are known by their place in Mechanism::getParts(), also before they are there.
    std::unordered_map<int, int> m_partIndex, m_pointMassIndex, m_flexBodyIndex;
    std::unordered_map<int, int> m_ownerOfMarker;
    std::unordered_map<int, std::vector<int>> m_markersOfOwner;
    std::unordered_map<int, const JointStatement*> m_joints;
    std::vector<SimTK::Constraint> m_working;  // those that may change the energy
    std::unordered_map<std::string, TreePlace> m_inTree;
    SimTK::Real m_lightestMass = 1;
    std::vector<NegativeMoment> m_negativeMoments;
    FunctionContext m_functions;
    ModesOfBodies m_modes;  // in SI until the body is added
};

}  // namespace jprim

#endif
