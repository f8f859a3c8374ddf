#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/experiments/result_fields.h"
#include "core/experiments/store/result_store.h"

// Rows of a result store's tables (schema.h), each added as it is. To be called within a Transaction.
namespace cullscope::store {

/// Both return the number of the new row.
[[nodiscard]] int64_t addMeasurement(const Database& database, const Listed& listed);
struct NewRun {
    int64_t measurement;
    size_t place;
    std::string strategy;
    bool askedFor, isLimit;
    std::string head;
    std::optional<std::string> figures{};
};
[[nodiscard]] int64_t addRun(const Database& database, const NewRun& run);

/// `judged`: what a summary needs of a judged frame besides its fields (judgedText); empty: nothing is known.
void addFrame(const Database& database, int64_t run, bool ownRaster, const ResultFields& fields,
              const std::vector<double>& frameTimes, const std::vector<double>& cullTimes, const std::string& judged);

/// Fields on one line, as a store keeps them.
[[nodiscard]] std::string compact(const ResultFields& fields);

}  // namespace cullscope::store
