# SPDX-License-Identifier: GPL-2.0-or-later
"""A run of lmp on a single rank that begins at once."""


def alone(folder):
    """Variables with which Open MPI starts a single rank without a daemon, in 0.2 s and not in 1 s.
    Its session directory lies in that folder, which no other run may use at the same time: one that
    ends could remove what another that begins has just made."""
    return {
        "OMPI_MCA_ess_singleton_isolated": "1",
        "OMPI_MCA_plm": "isolated",
        "OMPI_MCA_pml": "ob1",
        "OMPI_MCA_btl": "self",
        "OMPI_MCA_orte_tmpdir_base": str(folder),
    }
