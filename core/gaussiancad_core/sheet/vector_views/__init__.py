"""Views straight from the exact lines of PDF, SVG and DXF files, where these explain the ink."""
