#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "core/frame/commands.h"

namespace cullscope {

/// OpenGL's query objects of one context, which are used again. Tickets are given back on any thread, and also when the context
/// is gone: only `take` and `close` call OpenGL. A query is used again once its answer is there: a software OpenGL may still
/// count samples for a question that was given up, and would add them to those of the next one.
class BoxQueries {
public:
    /// So many queries. Needs the context.
    [[nodiscard]] std::vector<unsigned> take(size_t count);
    /// `answered`: whether their answers were read.
    void giveBack(std::span<const unsigned> queries, bool answered);
    /// Deletes all queries, also those that were not given back. Needs the context.
    void close();
    [[nodiscard]] bool closed() const;

private:
    /// Moves those whose answers are there by now to the unused ones, oldest first, until there are so many.
    void collect(size_t count);

    mutable std::mutex m_mutex;
    std::vector<unsigned> m_all, m_unused;
    std::deque<unsigned> m_unread;  ///< given back without a look at their answers, oldest first
    bool m_closed = false;
};

/// One query for each box, or each group of boxes, of a question.
class AskedTicket final : public BoxTicket {
public:
    /// Needs the context of `pool`.
    AskedTicket(std::shared_ptr<BoxQueries> pool, size_t queries)
        : BoxTicket(queries), m_pool(std::move(pool)), m_queries(m_pool->take(queries)) {}
    ~AskedTicket() override { m_pool->giveBack(m_queries, m_answer.has_value()); }

    [[nodiscard]] std::span<const unsigned> queries() const { return m_queries; }
    /// The numbers of the queries that passed; none in a context that is not that of `pool`.
    [[nodiscard]] std::optional<std::vector<uint32_t>> answer(const BoxQueries& pool);

private:
    std::shared_ptr<BoxQueries> m_pool;
    std::vector<unsigned> m_queries;
    std::mutex m_mutex;
    std::optional<std::vector<uint32_t>> m_answer;  ///< once it was asked for
};

}  // namespace cullscope
