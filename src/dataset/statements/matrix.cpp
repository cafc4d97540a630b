// SPDX-License-Identifier: Apache-2.0
// MATRIX: coefficients, by rows, by columns, or only those that are not zero. It is written by rows.
#include "base/format.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = MatrixStatement;
using V = ArgumentValue;

constexpr std::size_t MostValues = 1000000;

enum class ValueOrder { Rows, Columns };

const SpellingTable<ValueOrder>& getOrders() {
    static const SpellingTable<ValueOrder> orders = {{ValueOrder::Rows, "RORDER"},
                                                     {ValueOrder::Columns, "CORDER"}};
    return orders;
}

Field<S> fullField() {
    Field<S> full(ArgumentRule("FULL", Kind::WordSequence, 2).of(0, 1).among(getOrders().getWords()));
    full.write = [](StatementWriter& writer, const S&) { writer.add("FULL=RORDER"); };
    return full;
}

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {fullField(),
                                         ArgumentRule("RORDER", Kind::Choice),
                                         ArgumentRule("CORDER", Kind::Choice),
                                         ArgumentRule("SPARSE", Kind::Flag),
                                         field(ArgumentRule("M", Kind::Count, ExactOnly), &S::rows),
                                         field(ArgumentRule("N", Kind::Count, ExactOnly), &S::columns),
                                         field(ArgumentRule("VALUES", Kind::Real).of(1, NoLimit), &S::values),
                                         ArgumentRule("FILE", Kind::Ignored, 2),
                                         ArgumentRule("NAME", Kind::Ignored, 2)};
    return fields;
}

// What is given, understood when all is known.
struct MatrixArguments : S {
    std::vector<std::size_t> orders;  ///< of FULL
    V given;
};
using M = MatrixArguments;

const FieldTable<M>& getArguments() {
    static const FieldTable<M> arguments =
        FieldTable<M>{getFields()}
            .onRead("FULL", [](M& m, const V& given) { m.orders = given.words; })
            .onRead("VALUES", [](M& m, const V& given) { m.given = given; });
    return arguments;
}

bool checkNeeded(StatementReader& reader) {
    if (reader.has("FILE"))
        reader.addError(reader.getOffset("FILE"),
                        fmt::format("FILE of {}: matrices in files are not read; write M, N and VALUES",
                                    reader.getName()));
    else
        for (const char* name : {"M", "N", "VALUES"}) reader.checkNeeded(name, true);
    reader.checkNotBoth("SPARSE", "FULL");
    reader.checkNotBoth("SPARSE", "RORDER");
    reader.checkNotBoth("SPARSE", "CORDER");
    return !reader.hasErrors();
}

bool checkSize(StatementReader& reader, const M& matrix, std::size_t& size) {
    size = std::size_t(matrix.rows) * std::size_t(matrix.columns);
    if (size > MostValues) {
        reader.addError(0, fmt::format("{} has {} times {} values; at most {} are possible", reader.getName(),
                                       matrix.rows, matrix.columns, MostValues));
        return false;
    }
    const std::size_t count = matrix.given.numbers.size();
    if (reader.has("SPARSE") ? count % 3 == 0 : count == size) return true;
    reader.addError(
        reader.getOffset("VALUES"),
        reader.has("SPARSE")
            ? fmt::format("VALUES of {} takes row, column and value of each entry, so their "
                          "number is a multiple of 3, not {}",
                          reader.getName(), count)
            : fmt::format("VALUES of {} takes {} numbers, M times N, not {}", reader.getName(), size, count));
    return false;
}

void takeSparse(StatementReader& reader, M& matrix) {
    const V& given = matrix.given;
    for (std::size_t k = 0; k < given.numbers.size() && !reader.hasErrors(); k += 3) {
        const double row = given.numbers[k], column = given.numbers[k + 1];
        const auto check = [&](std::size_t at, const char* what, double number, int last) {
            if (number >= 1 && number <= last && number == double(int(number))) return;
            reader.addError(given.offsets[at],
                            fmt::format("VALUES of {}: {} is not a {}; these are whole numbers from 1 to {}",
                                        reader.getName(), number, what, last));
        };
        check(k, "row", row, matrix.rows);
        check(k + 1, "column", column, matrix.columns);
        if (!reader.hasErrors())
            matrix.values[std::size_t(row - 1) * std::size_t(matrix.columns) + std::size_t(column - 1)] =
                given.numbers[k + 2];
    }
}

void takeFull(StatementReader& reader, M& matrix) {
    const bool byColumns =
        reader.has("CORDER") ||
        (!matrix.orders.empty() && getOrders().getValue(matrix.orders[0]) == ValueOrder::Columns);
    const std::size_t rows = std::size_t(matrix.rows), columns = std::size_t(matrix.columns);
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j)
            matrix.values[i * columns + j] = matrix.given.numbers[byColumns ? j * rows + i : i * columns + j];
}

void read(StatementReader& reader) {
    M matrix;
    std::size_t size = 0;
    if (!reader.readStatement(getArguments(), matrix) || !checkNeeded(reader) ||
        !checkSize(reader, matrix, size))
        return;
    matrix.values.assign(size, 0);
    if (reader.has("SPARSE"))
        takeSparse(reader, matrix);
    else
        takeFull(reader, matrix);
    if (!reader.hasErrors()) reader.updState().dataset.matrices.push_back(std::move(matrix));
}

}  // namespace

StatementKind describeMatrix() {
    return readBy(read, makeKind("MATRIX", 3, getFields(), &Dataset::matrices));
}

}  // namespace jprim
