// SIGINT and SIGTERM as a question that a Monitor can ask.
//
// While nothing is computed yet a signal ends the program at once. From `begin_computation` on the
// first one only raises a flag, and a second one has its default action. A signal that was ignored
// when the program started stays ignored. SIGPIPE and SIGXFSZ are ignored: a closed pipe or a limit on
// the size of files is an error of writing.
#pragma once

namespace ucvt {

void catch_signals();

/// From here on an interruption is noted and asked for by `interrupted`.
void begin_computation();

bool interrupted();

}  // namespace ucvt
