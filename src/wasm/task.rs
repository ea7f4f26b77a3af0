//! An experiment that is read once and driven often.

use wasm_bindgen::prelude::*;

use super::Result;
use super::origin;
use super::read::Given;
use super::write::plain;
use crate::outside;
use crate::run::{Preset, Setting};

/// An experiment that is read once. Its methods are the functions of the same names without their first argument.
#[wasm_bindgen]
pub struct Task {
    setting: Setting,
    /// What filled it in.
    preset: Preset,
}

#[wasm_bindgen]
impl Task {
    /// Throws an Error that names the field when one is unknown, of a wrong type, or out of its range.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "PartialExperiment | Preset")] experiment: JsValue,
    ) -> Result<Task> {
        let (setting, preset) = outside::setting(&Given::of(experiment))?;
        Ok(Self { setting, preset })
    }

    /// The experiment with every field filled in.
    #[wasm_bindgen(getter, unchecked_return_type = "Experiment")]
    pub fn experiment(&self) -> JsValue {
        origin::remembered(self.setting.experiment(), self.preset)
    }
}

/// Methods of a task, and functions of the same names that read the experiment themselves.
macro_rules! tasks {
    ($setting:ident $(
        $doc:literal
        $name:ident $js:literal($($given:ident: $type:literal),+ $(; $last:ident)?) -> $returned:ty as $told:literal
        $body:block
    )+) => {
        #[wasm_bindgen]
        impl Task {$(
            #[doc = $doc]
            #[wasm_bindgen(js_name = $js, unchecked_return_type = $told)]
            pub fn $name(
                &self,
                $(#[wasm_bindgen(unchecked_param_type = $type)] $given: JsValue,)+
                $(#[wasm_bindgen(unchecked_optional_param_type = "number")] $last: JsValue,)?
            ) -> Result<JsValue> {
                let told = outside::$name(&self.setting, $(&Given::of($given),)+ $(&Given::of($last))?);
                Ok(plain(&told?))
            }
        )+}

        $(
            #[doc = $doc]
            #[wasm_bindgen(js_name = $js, unchecked_return_type = $told)]
            pub fn $name(
                #[wasm_bindgen(unchecked_param_type = "PartialExperiment | Preset")] experiment: JsValue,
                $(#[wasm_bindgen(unchecked_param_type = $type)] $given: JsValue,)+
                $(#[wasm_bindgen(unchecked_optional_param_type = "number")] $last: JsValue,)?
            ) -> Result<JsValue> {
                Task::new(experiment)?.$name($($given,)+ $($last)?)
            }
        )+
    };
}

outside::calls!(tasks);
