"""The study of the source, whose figures are computed once for all tests."""

from wrcontact.study.figure import Study

STUDY = Study()
