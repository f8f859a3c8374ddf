#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cullscope {

/// A box of a flow chart, at a place in a grid: columns to the right and rows downward.
struct FlowBox {
    enum class Kind { Structure, Action, Question };
    Kind kind = Kind::Action;
    std::string text;  ///< English, marked for translation
    double column = 0.0, row = 0.0;
    std::vector<uint8_t> lines{};  ///< of the strategy's listing, from 1: the box is lit while one of them is the current line
};

/// An arrow from one box to another, in straight pieces along the grid.
struct FlowArrow {
    enum class Way {
        Straight,  ///< down, or to the side
        Across     ///< to the side, then down
    };
    size_t from = 0, to = 0;  ///< numbers of boxes
    std::string words{};      ///< beside its beginning; marked for translation
    Way way = Way::Straight;
};

/// Rows of a chart that happen at one time, from a row to that of the next part.
struct FlowPart {
    size_t row = 0;
    std::string words;  ///< when; marked for translation
};

/// A strategy as a flow chart whose boxes are linked with the lines of its listing (frame/listing.h): plain data.
struct FlowChart {
    std::vector<FlowBox> boxes;
    std::vector<FlowArrow> arrows;
    std::vector<FlowPart> parts{};  ///< by ascending row

    [[nodiscard]] bool empty() const { return boxes.empty(); }
};

}  // namespace cullscope
