import { createEngine } from '../../../../www/core/engine.js';

// One file must hold this text unharmed.
document.title = '</script><!--<script>';
Object.assign(window, { engine: await createEngine() });
