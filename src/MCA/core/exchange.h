// SPDX-License-Identifier: GPL-2.0-or-later
/// \file exchange.h
/// What a step asks of whoever knows the other ranks. A pair of automata of two ranks is in the
/// list of both, so that forces are never sent back; what a rank lacks are values of automata that
/// others own: its guests. They go as the first values of rows, from the owner's row to that of the
/// guest.
#ifndef MCA_EXCHANGE_H
#define MCA_EXCHANGE_H

namespace mca {

/// Brings values of own automata to the ranks that have them as guests. Messages come in the order
/// in which they were sent, and all ranks call the same ones.
class Exchange {
 public:
  virtual ~Exchange() = default;

  /// Most values of an automaton in one message.
  static constexpr int mostValues = 8;

  /// No other rank has a part of the sample: there are no guests on any rank, and nothing is sent.
  virtual bool alone() const { return true; }

  /// Sends `count` values of each own automaton that is needed; finish() must follow before the
  /// next begin(). In between the caller may work on what needs no guest.
  /// \param rows    `stride` values an automaton, of which the first `count` are sent
  /// \param stride  values from one automaton to the next, >= count
  /// \param count   1 to mostValues
  virtual void begin(const double * /*rows*/, int /*stride*/, int /*count*/) {}

  /// Receives those of the guests into their rows.
  virtual void finish(double * /*rows*/, int /*stride*/, int /*count*/) {}
};

} // namespace mca

#endif
