// SPDX-License-Identifier: Apache-2.0
#include "mechanism/control/linear_systems.h"

#include <algorithm>
#include <map>

#include "base/format.h"

namespace jprim {
namespace {

const char* getLetter(ArrayType type) {
    switch (type) {
        case ArrayType::Constants: return "IC";
        case ArrayType::Inputs: return "U";
        case ArrayType::States: return "X";
        case ArrayType::Outputs: break;
    }
    return "Y";
}

template <class Statements>
auto findStatement(const Statements& statements, int id) {
    const auto found =
        std::find_if(statements.begin(), statements.end(), [id](const auto& s) { return s.id == id; });
    return found == statements.end() ? nullptr : &*found;
}

// Makes one system after the other. What is missing was reported, or was faulty itself, and makes the system useless.
class SystemMaker {
public:
    SystemMaker(const Dataset& dataset, const ReportMistake& report) : m_dataset(dataset), m_report(report) {}

    std::vector<LinearSystem> run() {
        for (const LseStatement& s : m_dataset.lses) {
            begin(fmt::format("LSE/{}", s.id), s);
            describe(s);
            finish();
        }
        for (const TfsisoStatement& s : m_dataset.tfsisos) {
            begin(fmt::format("TFSISO/{}", s.id), s);
            describe(s);
            finish();
        }
        return std::move(m_systems);
    }

private:
    template <class Statement>
    void begin(const std::string& name, const Statement& s) {
        m_isGood = true;
        m_system = LinearSystem();
        m_system.where = s.where;
        m_system.name = name;
        m_system.x = s.x;
        m_system.u = s.u;
        m_system.y = s.y;
        m_system.staticHold = s.staticHold;
    }

    void finish() {
        if (m_isGood) m_systems.push_back(std::move(m_system));
    }

    void addError(const std::string& message) {
        m_isGood = false;
        m_report(m_system.where, m_system.name + ": " + message);
    }

    // An array of its own kind, that no other system has; null if there is none.
    const ArrayStatement* findArray(int id, ArrayType type) {
        if (id == 0) return nullptr;
        const ArrayStatement* array = findStatement(m_dataset.arrays, id);
        m_isGood = m_isGood && array;
        if (!array) return nullptr;
        const char* const letter = getLetter(type);
        if (array->type != type) {
            addError(fmt::format("its {} must be an ARRAY of that type, but ARRAY/{} is one of type {}",
                                 letter, id, getLetter(array->type)));
            return nullptr;
        }
        if (type != ArrayType::States && type != ArrayType::Outputs) return array;
        const auto [owner, isNew] = m_owners.try_emplace(id, m_system.name);
        if (!isNew)
            addError(fmt::format("its {}, ARRAY/{}, is that of {} already; each system has its own", letter,
                                 id, owner->second));
        return array;
    }

    void checkSize(const ArrayStatement* array, const char* letter, int size, int needed) {
        if (array && size != 0 && size != needed)
            addError(fmt::format("its {}, ARRAY/{}, has {} elements where {} are needed", letter, array->id,
                                 size, needed));
    }

    void takeArrays(int numOutputs) {
        const ArrayStatement* x = findArray(m_system.x, ArrayType::States);
        const ArrayStatement* u = findArray(m_system.u, ArrayType::Inputs);
        const ArrayStatement* y = findArray(m_system.y, ArrayType::Outputs);
        if (x) checkSize(x, "X", x->size, m_system.numStates);
        if (y) checkSize(y, "Y", y->size, numOutputs);
        if (u) m_system.inputs = u->variables;
        m_system.numOutputs = numOutputs;
    }

    Coefficients findMatrix(int id) {
        if (id == 0) return {};
        const MatrixStatement* matrix = findStatement(m_dataset.matrices, id);
        m_isGood = m_isGood && matrix;
        return matrix ? Coefficients{matrix->rows, matrix->columns, matrix->values} : Coefficients{};
    }

    void checkMatrix(const char* name, int id, const Coefficients& matrix, int rows, int columns) {
        if (matrix.rows != rows || matrix.columns != columns)
            addError(fmt::format("its {}, MATRIX/{}, has {} rows and {} columns; it must have {} and {}",
                                 name, id, matrix.rows, matrix.columns, rows, columns));
    }

    void describe(const LseStatement& s) {
        m_system.A = findMatrix(s.a);
        m_system.B = findMatrix(s.b);
        m_system.C = findMatrix(s.c);
        m_system.D = findMatrix(s.d);
        if (!m_isGood) return;
        const int n = m_system.numStates = m_system.A.rows;
        const int numOutputs = s.c != 0 ? m_system.C.rows : m_system.D.rows;
        takeArrays(numOutputs);
        const int numInputs = int(m_system.inputs.size());
        checkMatrix("A", s.a, m_system.A, n, n);
        if (!m_isGood) return;
        if (s.b != 0) checkMatrix("B", s.b, m_system.B, n, numInputs);
        if (s.c != 0) checkMatrix("C", s.c, m_system.C, numOutputs, n);
        if (s.d != 0) checkMatrix("D", s.d, m_system.D, numOutputs, numInputs);
        m_system.initial.assign(size_t(n), 0);
        const ArrayStatement* ic = findArray(s.ic, ArrayType::Constants);
        if (!ic) return;
        checkSize(ic, "IC", ic->numbers.empty() ? ic->size : int(ic->numbers.size()), n);
        if (!ic->numbers.empty()) m_system.initial = ic->numbers;
    }

    // Controllable canonical form: the states are u/denominator and its derivatives.
    void describe(const TfsisoStatement& s) {
        const int n = m_system.numStates = int(s.denominator.size()) - 1;
        takeArrays(1);
        if (!m_isGood) return;
        checkSize(findStatement(m_dataset.arrays, s.u), "U", int(m_system.inputs.size()), 1);
        const double highest = s.denominator.back();
        const auto getNumerator = [&s](int k) {
            return size_t(k) < s.numerator.size() ? s.numerator[size_t(k)] : 0;
        };
        const double through = getNumerator(n) / highest;
        m_system.A = {n, n, std::vector<double>(size_t(n * n), 0)};
        m_system.B = {n, 1, std::vector<double>(size_t(n), 0)};
        m_system.C = {1, n, std::vector<double>(size_t(n), 0)};
        m_system.D = {1, 1, {through}};
        for (int k = 0; k + 1 < n; ++k) m_system.A.values[size_t(k * n + k + 1)] = 1;
        for (int k = 0; k < n; ++k) {
            m_system.A.values[size_t((n - 1) * n + k)] = -s.denominator[size_t(k)] / highest;
            m_system.C.values[size_t(k)] = getNumerator(k) - s.denominator[size_t(k)] * through;
        }
        m_system.B.values.back() = 1 / highest;
        m_system.initial.assign(size_t(n), 0);
    }

    const Dataset& m_dataset;
    const ReportMistake& m_report;
    std::vector<LinearSystem> m_systems;
    LinearSystem m_system;
    bool m_isGood = true;
    std::map<int, std::string> m_owners;  // of X and Y arrays
};

}  // namespace

std::vector<LinearSystem> makeLinearSystems(const Dataset& dataset, const ReportMistake& report) {
    return SystemMaker(dataset, report).run();
}

}  // namespace jprim
