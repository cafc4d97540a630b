// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_DATASET_DATASET_H_
#define JPRIM_DATASET_DATASET_H_

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "jprim/base/diagnostic.h"
#include "jprim/base/units.h"
#include "jprim/dataset/constraint_statements.h"
#include "jprim/dataset/control_statements.h"
#include "jprim/dataset/force_statements.h"
#include "jprim/dataset/graphics_statement.h"
#include "jprim/dataset/source_text.h"

/// @file
/// An Adams/Solver dataset (.adm) as plain values: what the file says, in the file's own units, nothing
/// interpreted. Ids are Adams' integers; 0 means "not given" (or ground, where a statement allows that).
/// Angles are radians, whether written with the D suffix or not. Every statement knows where it began.
/// Two statements compare equal when they say the same; `where` is not compared.
namespace jprim {

/// UNITS: the names as understood, in full, and their factors to SI. Without a UNITS statement every
/// factor is 1, which reads the numbers as SI.
struct UnitsStatement {
    SourcePosition where;
    /// Full Adams names in the order force, mass, length, time; empty where SYSTEM was given.
    std::array<std::string, 4> names;
    /// MKS, CGS, FPS, IPS or NONE; empty where the four names were given.
    std::string system;
    UnitSystem toSI;
    /// The given unit consistency factor, if any; forces are then FORCE * UCF = MASS * acceleration.
    std::optional<double> ucf;
};

/// ACCGRAV: acceleration of gravity in ground axes, length/time^2.
struct AccgravStatement {
    SourcePosition where;
    Triple acceleration{};
};

/// The coordinates that EXACT can name, in the order of RigidCoordinates::exact.
enum class PartCoordinate { X, Y, Z, Psi, Theta, Phi };

/// What PART and FLEX_BODY say in the same words: where the body begins, and how it moves there.
struct RigidCoordinates {
    std::optional<Triple> qg;      ///< origin of the body coordinate system (BCS) in ground axes; 0,0,0
    std::optional<Triple> reuler;  ///< BCS orientation: body-fixed 3-1-3 angles; excludes zg and xg
    std::optional<Triple> zg;      ///< a point on the BCS' +z axis, in ground axes
    std::optional<Triple> xg;      ///< a point in the +x half of the BCS' xz plane, in ground axes
    std::array<std::optional<double>, 3> v;  ///< VX VY VZ of the mass centre; empty means free
    std::array<std::optional<double>, 3> w;  ///< WX WY WZ; empty means free
    int vm = 0;                              ///< marker whose axes v is along; ground axes if 0
    int wm = 0;                   ///< marker whose axes w is about; if 0 cm's, of a FLEX_BODY the BCS'
    std::array<bool, 6> exact{};  ///< EXACT, indexed by PartCoordinate
};

/// PART: a rigid body, or ground.
struct PartStatement : RigidCoordinates {
    SourcePosition where;
    int id = 0;
    bool ground = false;
    std::optional<double> mass;
    int cm = 0;                               ///< marker at the mass centre
    int im = 0;                               ///< inertia marker; cm if 0
    std::optional<std::array<double, 6>> ip;  ///< xx, yy, zz, xy, xz, yz about im; products as +Int(xy dm)
};

/// FLEX_BODY: a flexible body described by the modes in a file. Its BCS is the frame of the mesh.
struct FlexBodyStatement : RigidCoordinates {
    SourcePosition where;
    int id = 0;
    std::string modesFile;          ///< as written; a relative name starts from Dataset::folder
    std::optional<double> cratio;   ///< fraction of critical damping of every mode; by frequency if empty
    bool constantCoupling = false;  ///< INVARIANTS: inertia coupling Constant instead of Partial
};

/// POINT_MASS: a body with three freedoms, that never turns. A kind of its own beside PART, as FLEX_BODY is:
/// its ids are its own (POINT_MASS/3 is not PART/3), and nothing that is said of parts (ground, inertia) can
/// be said of it. Of its coordinates `w`, `vm` and `wm` are never given, of `exact` only X, Y and Z.
struct PointMassStatement : RigidCoordinates {
    SourcePosition where;
    int id = 0;
    std::optional<double> mass;
    int cm = 0;  ///< marker at the mass
};

/// MARKER: a frame fixed to a body. Pose in the owner's BCS, before it deforms. After reading exactly one of
/// `part`, `pointMass` and `flexBody` is not 0: the nearest of these statements before it is the default.
struct MarkerStatement {
    SourcePosition where;
    int id = 0;
    int part = 0;       ///< the owner if it is a PART
    int pointMass = 0;  ///< the owner if it is a POINT_MASS
    int flexBody = 0;   ///< the owner if it is a FLEX_BODY
    int node = 0;       ///< NODE_ID, 0 if not given; without effect on a PART
    /// Where it is, is decided by the VFORCE, VTORQUE or GFORCE that names it as JFLOAT, the only statements
    /// that may name it; then no member below is given.
    bool floating = false;
    std::optional<Triple> qp;
    std::optional<Triple> reuler;
    std::optional<Triple> zp;
    std::optional<Triple> xp;
    bool usexp = false;  ///< XP lies on the x axis and ZP in the xz plane, instead of the reverse
};

enum class RequestType { Displacement, Velocity, Acceleration, Force, Expressions };

/// REQUEST: what to write out. For Expressions the functions are kept unparsed, F1 … F8.
///
/// A request has eight components: F1 … F8, or for the other types the magnitude, x, y, z, then the same of the
/// rotation. The k-th name of a list belongs to the k-th component; an empty one says nothing, as does the end of a
/// list. The lists change no value.
struct RequestStatement {
    SourcePosition where;
    int id = 0;
    RequestType type = RequestType::Displacement;
    int i = 0;
    int j = 0;   ///< ground if 0
    int rm = 0;  ///< ground axes if 0
    std::string comment;
    std::string title;
    std::string resultsName;           ///< RESULTS_NAME, by which results call the request
    std::vector<std::string> cnames;   ///< CNAMES: what results call each component
    std::vector<std::string> cunits;   ///< CUNITS: what each is, "angle"
    std::vector<std::string> clabels;  ///< CLABELS: titles of the components in plots
    std::vector<std::string> ctitle;   ///< CTITLE: likewise
    std::vector<std::pair<int, ExpressionText>> expressions;  ///< (2, "DX(1,2)") for F2=DX(1,2)
};

/// VARIABLE: a value that expressions read as VARVAL(id). It may depend on other variables, and on itself.
struct VariableStatement {
    SourcePosition where;
    int id = 0;
    ExpressionText function;
    std::optional<double> ic;  ///< a first guess of the value at the start
};

/// SPLINE: the table behind AKISPL(x, z, id) and CUBSPL(x, z, id).
struct SplineStatement {
    SourcePosition where;
    int id = 0;
    std::vector<double> x;  ///< strictly increasing, at least 4
    /// (z, y at each x), z strictly increasing. One curve with z = 0 if y depends on x only.
    std::vector<std::pair<double, std::vector<double>>> curves;
    bool linearExtrapolate = false;  ///< LINEAR_EXTRAPOLATE: go on along the end tangents
};

enum class SensorComparison { Equal, GreaterOrEqual, LessOrEqual };

/// SENSOR: notes a value, or ends the simulation, when its function f reaches a value: |f - value| <= error (Equal),
/// f >= value - error (GreaterOrEqual) or f <= value + error (LessOrEqual).
struct SensorStatement {
    SourcePosition where;
    int id = 0;
    ExpressionText function;
    double value = 0;
    double error = 1e-3;
    SensorComparison comparison = SensorComparison::Equal;
    bool halt = false;         ///< HALT: end the run
    bool endsCommand = false;  ///< RETURN: end the SIMULATE that runs, and go on with the next command
    /// EVALUATE: what SENVAL(id) is from the moment at which the function reaches the value; 0 before.
    std::optional<ExpressionText> evaluate;
};

/// A statement that changes no motion, or only the numerical method: read, kept as text, otherwise ignored.
/// MATERIAL, MREQUEST, STRING; OUTPUT, RESULTS, DEBUG, PREFERENCES, INTEGRATOR,
/// KINEMATICS, EQUILIBRIUM, IC.
struct IgnoredStatement {
    SourcePosition where;
    std::string keyword;    ///< in full and upper case
    int id = 0;             ///< 0 for statements without id, such as OUTPUT
    std::string arguments;  ///< as they stand, comments and line breaks taken out
};

/// What became of the statements of a file; the three add up to the statements in it.
struct StatementCounts {
    int built = 0;    ///< became a member of the Dataset that has meaning for the mechanism
    int ignored = 0;  ///< by a declared rule, see IgnoredStatement
    int errors = 0;   ///< reported with their position
};

/// A whole dataset. Within a kind, statements stand in the order of the file.
struct Dataset {
    std::string title;
    std::string folder;  ///< of the file that was read by readDatasetFile(), else empty; not compared
    std::optional<UnitsStatement> units;
    std::optional<AccgravStatement> gravity;
    std::vector<PartStatement> parts;
    std::vector<PointMassStatement> pointMasses;
    std::vector<FlexBodyStatement> flexBodies;
    std::vector<MarkerStatement> markers;
    std::vector<JprimStatement> jprims;
    std::vector<JointStatement> joints;
    std::vector<GconStatement> gcons;
    std::vector<MotionStatement> motions;
    std::vector<CouplerStatement> couplers;
    std::vector<SforceStatement> sforces;
    std::vector<VectorForceStatement> vectorForces;
    std::vector<SpringdamperStatement> springdampers;
    std::vector<BushingStatement> bushings;
    std::vector<VariableStatement> variables;
    std::vector<SplineStatement> splines;
    std::vector<ArrayStatement> arrays;
    std::vector<MatrixStatement> matrices;
    std::vector<DiffStatement> diffs;
    std::vector<LseStatement> lses;
    std::vector<TfsisoStatement> tfsisos;
    std::vector<PlantStatement> plantInputs;
    std::vector<PlantStatement> plantOutputs;
    std::vector<SensorStatement> sensors;
    std::vector<RequestStatement> requests;
    std::vector<GraphicsStatement> graphics;
    std::vector<IgnoredStatement> ignored;
    StatementCounts counts;
    /// The ids of statements with errors, by keyword. Most are in none of the lists, but others may still name them.
    std::map<std::string, std::set<int>> faulty;
};

/// True if both say the same. How reading went (`where`, the folder, counts, faulty) is no part of what a dataset says.
bool operator==(const Dataset& a, const Dataset& b);
bool operator!=(const Dataset& a, const Dataset& b);

/// Adams' spelling of a type, in full and upper case: "DISPLACEMENT", "GE".
const char* getAdamsName(RequestType type);
const char* getAdamsName(SensorComparison comparison);

}  // namespace jprim

#endif
