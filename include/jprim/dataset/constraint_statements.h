// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_DATASET_CONSTRAINT_STATEMENTS_H_
#define JPRIM_DATASET_CONSTRAINT_STATEMENTS_H_

#include <optional>
#include <vector>

#include "jprim/base/diagnostic.h"
#include "jprim/base/kinematic_level.h"
#include "jprim/dataset/source_text.h"

/// @file
/// The statements of a dataset that take freedoms away: JPRIM, JOINT, GCON, MOTION, COUPLER. What holds for
/// all statements is said in dataset.h.
namespace jprim {

enum class JprimType { AtPoint, InLine, InPlane, Orientation, ParallelAxes, Perpendicular };

/// JPRIM: a joint primitive between markers I and J of different parts.
struct JprimStatement {
    SourcePosition where;
    int id = 0;
    JprimType type = JprimType::AtPoint;
    int i = 0;
    int j = 0;
};

enum class JointType {
    Spherical,
    Revolute,
    Cylindrical,
    Translational,
    Planar,
    Fixed,
    Universal,
    Hooke,
    Convel,
    Screw,   ///< one equation: I moves along zJ by the pitch in one turn; nothing else is held
    Rackpin  ///< one equation: the rack moves by half the pitch diameter times the pinion's angle
};

/// A coordinate of a joint at the start, of I with respect to J: a length or an angle in radians.
struct JointInitialValue {
    double displacement = 0;
    std::optional<double> velocity;
};

/// JOINT: a joint of the catalogue between markers I and J of different parts.
struct JointStatement {
    SourcePosition where;
    int id = 0;
    JointType type = JointType::Spherical;
    int i = 0;
    int j = 0;
    std::optional<double> pitch;          ///< PITCH: length per turn, right-hand if positive; given if Screw
    std::optional<double> diameter;       ///< PD: pitch diameter of the pinion, not 0; given if Rackpin
    std::optional<JointInitialValue> ic;  ///< IC of a Revolute or Translational
    std::optional<JointInitialValue> icTranslation;  ///< ICTRAN of a Cylindrical
    std::optional<JointInitialValue> icRotation;     ///< ICROT of a Cylindrical
};

/// GCON: the equation `function = 0`.
struct GconStatement {
    SourcePosition where;
    int id = 0;
    int i = 0;  ///< the marker that the reaction is reported on; ground if 0
    ExpressionText function;
};

/// The coordinate that a MOTION prescribes.
enum class MotionAxis {
    Joint,        ///< the only one of a Revolute or Translational joint
    Rotation,     ///< of a Revolute or Cylindrical joint: angle of xI from xJ about zJ
    Translation,  ///< of a Translational or Cylindrical joint: I from J along zJ
    X,            ///< I from J along J's axes
    Y,
    Z,
    B1,  ///< body-fixed 1-2-3 angles of I in J: R_JI = Rx(B1) Ry(B2) Rz(B3)
    B2,
    B3
};

/// MOTION: prescribes a coordinate of a joint (form 1) or between two markers (form 2). After reading
/// either `joint` is given or both `i` and `j`. A joint named is a Revolute, Translational or Cylindrical,
/// and it has the axis.
struct MotionStatement {
    SourcePosition where;
    int id = 0;
    int joint = 0;  ///< 0 in form 2
    int i = 0;      ///< 0 in form 1
    int j = 0;
    MotionAxis axis = MotionAxis::Joint;  ///< Joint, Rotation, Translation in form 1; X … B3 in form 2
    KinematicLevel level = KinematicLevel::Position;  ///< what of the coordinate the function gives
    ExpressionText function;
    std::optional<double> icdisp;  ///< ICDISP: the coordinate at the start; only if level > Position
    std::optional<double> icvel;   ///< ICVEL: its rate at the start; only if level is Acceleration
};

/// The coordinate of a joint that takes part in a COUPLER.
enum class CouplerType { Translational, Rotational };

/// COUPLER: scales[0] q[0] + scales[1] q[1] (+ scales[2] q[2]) = 0, with q the joints' displacements of I
/// from J. The three lists have the same length, 2 or 3, also where the file leaves out what has a default:
/// types[k] is then the only coordinate that joints[k] has, and scales[0] is 1.
struct CouplerStatement {
    SourcePosition where;
    int id = 0;
    std::vector<int> joints;  ///< Revolute, Translational or Cylindrical
    std::vector<CouplerType> types;
    std::vector<double> scales;
};

/// Adams' spelling of a type, in full and upper case: "PARALLEL_AXES", "REVOLUTE", "B1".
[[nodiscard]] const char* getAdamsName(JprimType type);
[[nodiscard]] const char* getAdamsName(JointType type);
[[nodiscard]] const char* getAdamsName(MotionAxis axis);       ///< empty for Joint
[[nodiscard]] const char* getAdamsName(KinematicLevel level);  ///< DISPLACEMENT, VELOCITY or ACCELERATION
[[nodiscard]] const char* getAdamsName(CouplerType type);

}  // namespace jprim

#endif
