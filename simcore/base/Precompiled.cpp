// SPDX-License-Identifier: GPL-3.0-or-later
// Owner of the precompiled header that the libraries of simcore share.
