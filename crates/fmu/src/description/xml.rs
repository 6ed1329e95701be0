//! Writes elements and attributes.

use std::io;

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};

pub(super) type Xml = Writer<Vec<u8>>;

/// Attributes in their order.
pub(super) type Attributes = Vec<(&'static str, String)>;

/// Writes an XML document with one root element.
pub(super) fn document(
    name: &str,
    attributes: &[(&str, String)],
    inner: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> io::Result<String> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    element(&mut xml, name, attributes, inner)?;
    let mut bytes = xml.into_inner();
    bytes.push(b'\n');
    String::from_utf8(bytes).map_err(io::Error::other)
}

/// An element with content.
pub(super) fn element(
    xml: &mut Xml,
    name: &str,
    attributes: &[(&str, String)],
    inner: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> io::Result<()> {
    let attributes = attributes.iter().map(|(key, value)| (*key, value.as_str()));
    xml.create_element(name).with_attributes(attributes).write_inner_content(inner)?;
    Ok(())
}

/// An empty element.
pub(super) fn empty(xml: &mut Xml, name: &str, attributes: &[(&str, String)]) -> io::Result<()> {
    let attributes = attributes.iter().map(|(key, value)| (*key, value.as_str()));
    xml.create_element(name).with_attributes(attributes).write_empty()?;
    Ok(())
}

/// The definitions of units.
pub(super) fn units(
    xml: &mut Xml,
    units: &std::collections::BTreeSet<crate::Unit>,
) -> io::Result<()> {
    element(xml, "UnitDefinitions", &[], |xml| {
        for unit in units {
            let name = unit.name().unwrap_or_default().to_owned();
            element(xml, "Unit", &[("name", name)], |xml| {
                let bases = ["kg", "m", "s", "rad"].into_iter().zip(unit.exponents());
                let bases: Attributes =
                    bases.filter(|(_, e)| *e != 0).map(|(b, e)| (b, e.to_string())).collect();
                empty(xml, "BaseUnit", &bases)
            })?;
        }
        Ok(())
    })
}
