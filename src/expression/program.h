// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_PROGRAM_H_
#define JPRIM_SRC_EXPRESSION_PROGRAM_H_

#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

#include "expression/instruction.h"
#include "jprim/base/kinematic_level.h"

namespace jprim {

/// A value within a ProgramBuilder: a scalar or a vector of three.
struct Operand {
    int index = -1;
    bool isVector = false;
};

/// A function expression ready to be evaluated: straight-line code on scalars and vectors. Immutable, and
/// cheap to copy because copies share the code. An Evaluation runs it.
class Program {
public:
    bool isVector() const { return m_code->result.isVector; }

    /// All inputs that the builder was given before finish(), so that their numbers stay.
    int getNumScalarInputs() const { return static_cast<int>(m_code->scalarInputs.size()); }
    int getNumVectorInputs() const { return static_cast<int>(m_code->vectorInputs.size()); }

    /// True if the result depends on the input; others need not be supplied.
    bool usesScalarInput(int input) const { return m_code->scalarInputs.at(input) >= 0; }
    bool usesVectorInput(int input) const { return m_code->vectorInputs.at(input) >= 0; }

    /// The scalar input that is simulation time; -1 if the result does not depend on it.
    int getTimeInput() const { return m_code->timeInput; }

    /// The highest level of the inputs that the result depends on; Position if on none. Reactions count as
    /// accelerations.
    KinematicLevel getLevel() const { return m_code->level; }

    /// True if the result is a polynomial of at most first degree in the Velocity inputs, with coefficients
    /// that may depend on Position inputs and time, and has no Acceleration input. Decided from the operations
    /// alone: v/v is not recognised as a constant. False if any result of a Select is of higher degree, or
    /// if velocities decide which is taken.
    bool isLinearInVelocity() const { return m_code->velocityDegree <= 1; }

    /// The length of the code.
    int getNumOperations() const { return static_cast<int>(m_code->instructions.size()); }

    /// How many derivatives the result has, as far as functions given by data have them.
    int getNumDerivatives() const;

    /// How many angles an Evaluation has to remember.
    int getNumAngles() const { return static_cast<int>(m_code->angles.size()); }

    /// How much the result changes per radian of continuous angle k, if that is a constant; otherwise NaN.
    SimTK::Real getAngleSlope(int k) const { return m_code->angles.at(k).slope; }

    /// What decides between branches: the values whose signs do, of IF, MAX, STEP, IMPACT, ABS and the like.
    int getNumSwitches() const { return static_cast<int>(m_code->switches.size()); }
    /// The highest level of the inputs that switch k depends on.
    KinematicLevel getSwitchLevel(int k) const { return m_code->switches.at(k).level; }

    /// What whole turns of the angles add to the result are the multiples of this. Zero if there is no angle, if
    /// the result depends on one in another way than by a constant factor, or if the factors of several are not
    /// in the ratio of whole numbers up to LargestRatio.
    SimTK::Real findTurnPeriod() const;
    static constexpr int LargestRatio = 200;

private:
    friend class ProgramBuilder;
    friend class Evaluation;
    friend class TimeBreaks;

    // The registers of a continuous angle: what the evaluator remembers, what comes out.
    struct Angle {
        int remembered, result;
        SimTK::Real slope = SimTK::NaN;
    };
    struct Switch {
        int value;  // its register
        KinematicLevel level;
    };
    struct Code {
        std::vector<Instruction> instructions;
        Curves curves;
        Registers initial;                            // constants in their places, zero elsewhere
        std::vector<int> scalarInputs, vectorInputs;  // their registers; -1 for unused ones
        Operand result;
        KinematicLevel level = KinematicLevel::Position;
        int velocityDegree = 0;
        int timeInput = -1;
        std::vector<Angle> angles;
        std::vector<Switch> switches;
    };
    explicit Program(std::shared_ptr<const Code> code) : m_code(std::move(code)) {}
    static void findAngleSlopes(Code& code);

    std::shared_ptr<const Code> m_code;
};

/// Writes a Program, one operation at a time. Arguments of the wrong shape are a programming error (assert);
/// the parser checks shapes and reports them to the user. Operations on constants are done at once.
class ProgramBuilder {
public:
    /// Inputs: what the evaluator supplies. Numbered from 0, scalars and vectors apart; that is not the index of
    /// the operand.
    Operand addScalarInput(KinematicLevel level);
    Operand addVectorInput(KinematicLevel level);
    /// Simulation time [s]; the same scalar input whenever asked for.
    Operand time();
    /// How many there are by now, time included: the number that the next input gets.
    int getNumScalarInputs() const { return static_cast<int>(m_scalarInputs.size()); }
    int getNumVectorInputs() const { return static_cast<int>(m_vectorInputs.size()); }

    Operand number(SimTK::Real value);
    Operand vector(Operand x, Operand y, Operand z);
    Operand add(Operand a, Operand b);       // both scalars or both vectors
    Operand subtract(Operand a, Operand b);  // likewise
    Operand negate(Operand a);
    /// Scalar times scalar, scalar times vector in either order, or the dot product of two vectors.
    Operand multiply(Operand a, Operand b);
    Operand divide(Operand a, Operand b);  // by a scalar
    Operand cross(Operand a, Operand b);
    Operand norm(Operand a);
    Operand normalize(Operand a);  // a zero vector stays zero
    Operand component(Operand a, int axis);

    Operand call(Function function, Operand a);
    Operand power(Operand a, Operand b);
    Operand min(Operand a, Operand b);
    Operand max(Operand a, Operand b);
    /// a - b trunc(a/b), with the sign of a.
    Operand mod(Operand a, Operand b);
    /// |a| with the sign of b, where zero counts as positive.
    Operand sign(Operand a, Operand b);
    /// a - b if that is positive, else zero.
    Operand dim(Operand a, Operand b);
    /// One of three scalars, by the sign of `condition`.
    Operand select(Operand condition, Operand ifNegative, Operand ifZero, Operand ifPositive);
    /// A function given by data. A curve of x alone ignores z.
    Operand curve(std::shared_ptr<const Curve> curve, Operand x, Operand z);

    /// The angle of the point (x, y) in (-pi, pi] [rad]; 0 for the origin.
    Operand atan2(Operand y, Operand x);
    /// atan2 made continuous in time by whole turns: so many that it is within half a turn of an angle that the
    /// evaluator remembers.
    Operand continuousAngle(Operand y, Operand x);

    /// True if the value depends on no input; then getConstant() has it.
    bool isConstant(Operand a) const { return getTraits(a).isConstant; }
    SimTK::Real getConstant(Operand scalar) const;
    /// What Program::getLevel() and Program::isLinearInVelocity() would say of it as a result.
    KinematicLevel getLevel(Operand a) const { return getTraits(a).level; }
    bool isLinearInVelocity(Operand a) const { return getTraits(a).velocityDegree <= 1; }
    /// False for a constant that is infinite or no number, such as 1/0.
    bool isFinite(Operand a) const;

    /// The program that calculates `result`, without the operations that it does not need. The builder may
    /// go on and finish other results.
    Program finish(Operand result) const;

private:
    // What is known of a value without evaluating it. The degree in velocities stops at 2, for anything
    // that is not of degree 0 or 1.
    struct Traits {
        bool isConstant = false;
        KinematicLevel level = KinematicLevel::Position;
        int velocityDegree = 0;
    };

    Operand makeOperand(bool isVector, const Traits& traits);
    Operand addInput(bool isVector, KinematicLevel level);
    Operand emit(Operation operation, std::initializer_list<Operand> arguments, int detail = 0);
    Operand callTwo(Function function, Operand x, Operand y);
    const Traits& getTraits(Operand a) const;
    Traits combineTraits(Operation operation, const std::initializer_list<Operand>& arguments) const;

    std::vector<Instruction> m_instructions;
    Curves m_curves;
    Registers m_values;  // of constants
    std::vector<Traits> m_scalarTraits, m_vectorTraits;
    std::vector<int> m_scalarInputs, m_vectorInputs;  // their registers
    std::vector<Program::Angle> m_angles;
    int m_timeInput = -1;
};

}  // namespace jprim

#endif
