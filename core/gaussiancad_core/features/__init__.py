"""Features of an exact solid: the pads, pockets, holes and edge breaks that it can be made of.

The solid is undressed of fillets and chamfers, its round holes are set aside, and what is left is
covered by prisms and turned bodies.  Everything that is found is built again and compared.
"""
