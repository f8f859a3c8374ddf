#include "core/gpu/box_queries.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace cullscope {

std::vector<unsigned> BoxQueries::take(size_t count) {
    const std::lock_guard lock(m_mutex);
    collect(count);
    if (m_unused.size() < count) {
        std::vector<unsigned> made(count - m_unused.size());
        glCreateQueries(GL_ANY_SAMPLES_PASSED_CONSERVATIVE, static_cast<GLsizei>(made.size()), made.data());
        m_all.insert(m_all.end(), made.begin(), made.end());
        m_unused.insert(m_unused.end(), made.begin(), made.end());
    }
    const auto first = m_unused.end() - static_cast<std::ptrdiff_t>(count);
    std::vector<unsigned> taken(first, m_unused.end());
    m_unused.erase(first, m_unused.end());
    return taken;
}

void BoxQueries::collect(size_t count) {
    while (m_unused.size() < count && !m_unread.empty()) {
        GLuint there = GL_FALSE;
        glGetQueryObjectuiv(m_unread.front(), GL_QUERY_RESULT_AVAILABLE, &there);
        if (there == GL_FALSE) return;
        m_unused.push_back(m_unread.front());
        m_unread.pop_front();
    }
}

void BoxQueries::giveBack(std::span<const unsigned> queries, bool answered) {
    const std::lock_guard lock(m_mutex);
    if (m_closed) return;
    if (answered)
        m_unused.insert(m_unused.end(), queries.begin(), queries.end());
    else
        m_unread.insert(m_unread.end(), queries.begin(), queries.end());
}

void BoxQueries::close() {
    const std::lock_guard lock(m_mutex);
    glDeleteQueries(static_cast<GLsizei>(m_all.size()), m_all.data());
    m_all.clear();
    m_unused.clear();
    m_unread.clear();
    m_closed = true;
}

bool BoxQueries::closed() const {
    const std::lock_guard lock(m_mutex);
    return m_closed;
}

std::optional<std::vector<uint32_t>> AskedTicket::answer(const BoxQueries& pool) {
    if (m_pool.get() != &pool || m_pool->closed()) return std::nullopt;
    const std::lock_guard lock(m_mutex);
    if (!m_answer) {
        m_answer.emplace();
        for (size_t query = 0; query < m_queries.size(); ++query) {
            GLuint any = GL_FALSE;
            glGetQueryObjectuiv(m_queries[query], GL_QUERY_RESULT, &any);
            if (any != GL_FALSE) m_answer->push_back(static_cast<uint32_t>(query));
        }
    }
    return m_answer;
}

}  // namespace cullscope
