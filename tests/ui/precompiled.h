// The same for the tests of the desktop, with the widgets.
#pragma once

#include <QtWidgets>

#include "tests/precompiled.h"
