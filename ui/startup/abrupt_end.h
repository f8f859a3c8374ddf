#pragma once

#include <QString>
#include <functional>

namespace cullscope::ui {

/// Ends that the desktop's libraries bring about: they exit or crash where the connection to the display breaks, and wait
/// forever where the system gives Qt no thread. While an object of this class exists the program says either in one sentence on
/// standard error, and ends with the status of ErrorKind::OpenGl or ErrorKind::Input. One at a time, for all of the
/// application's life.
class AbruptEnd {
public:
    AbruptEnd();
    ~AbruptEnd();
    AbruptEnd(const AbruptEnd&) = delete;
    AbruptEnd& operator=(const AbruptEnd&) = delete;

    /// `keep` is called before such an end and keeps the session; it returns whether it could. Not called where the end comes on
    /// another thread than the one that calls this function. Empty: nothing is kept from now on.
    void keepBy(std::function<bool()> keep);
};

/// Ends so where the text is a warning of Qt's behind which it exits or waits. For message handlers that stand in the place of
/// AbruptEnd's for some time.
void endWhereQtCannotGoOn(const QString& warning);

}  // namespace cullscope::ui
