// SPDX-License-Identifier: GPL-2.0-or-later
// The table of automaton states against what restart files hold.
#include "core/automaton_states.h"

#include <gtest/gtest.h>

#include <set>

TEST(AutomatonStates, StandInRestartFilesInThisOrder)
{
  EXPECT_EQ(mca::propertyWords(2),
            "d_mca_kappa d_mca_theta d_mca_lag_x d_mca_lag_y d_mca_rest_x d_mca_rest_y "
            "d_mca_links0 d_mca_broken d_mca_formed d_mca_kept");
  EXPECT_EQ(mca::propertyWords(3),
            "d_mca_kappa d_mca_theta d_mca_lag_x d_mca_lag_y d_mca_rest_x d_mca_rest_y "
            "d_mca_lag_z d_mca_rest_z d_mca_links0 d_mca_broken d_mca_formed d_mca_kept");
  EXPECT_EQ(mca::propertyWords(2, false), "d_mca_spin_lag_z d_mca_spin_rest_z");
  EXPECT_EQ(mca::propertyWords(3, false),
            "d_mca_spin_lag_x d_mca_spin_lag_y d_mca_spin_lag_z d_mca_spin_rest_x "
            "d_mca_spin_rest_y d_mca_spin_rest_z");
}

TEST(AutomatonStates, AreFoundByTheirNames)
{
  std::set<std::string> names;
  for (int k = 0; k < mca::stateCount; k++) {
    EXPECT_EQ(mca::stateNumber(mca::automatonStates[k].name), k);
    names.insert(mca::automatonStates[k].name);
  }
  EXPECT_EQ(names.size(), static_cast<size_t>(mca::stateCount));
  EXPECT_THROW(mca::stateNumber("kapa"), std::logic_error);
}

TEST(AutomatonStates, AreShownOnlyWhereTheyExist)
{
  for (const mca::AutomatonState &state : mca::automatonStates) {
    EXPECT_EQ(state.attribute != nullptr, state.shown != mca::In::None) << state.name;
    for (const int dimension : {2, 3})
      EXPECT_LE(mca::existsIn(state.shown, dimension), mca::existsIn(state.exists, dimension))
          << state.name;
  }
}
