#include <algorithm>
#include <iterator>
#include <utility>

#include "tests/real_inputs/row.h"

namespace vantage::real_inputs {

std::span<const Row> table() {
    static const std::vector<Row> all = [] {
        std::vector<Row> rows = scan_rows();
        for (std::vector<Row> more : {photo_rows(), command_rows()})
            std::ranges::move(more, std::back_inserter(rows));
        return rows;
    }();
    return all;
}

}  // namespace vantage::real_inputs
