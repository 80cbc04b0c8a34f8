"""Any result against any reference: sampling, registration, distances, deviation.

The protocol is the one of the GaussianCAD paper where it says what it does (both models in a 5-unit
box, registered, CD, HD and EMD of surface points), with what it leaves open written down here: the
number of points, their floor, and two measures that have no floor (distance to the exact surface,
volume IoU).
"""
