<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it_IT" sourcelanguage="en">
<context>
    <name>Commands</name>
    <message>
        <source>&amp;Quit</source>
        <translation>Es&amp;ci</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Chiudi la finestra</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>Sc&amp;orciatoie…</translation>
    </message>
    <message>
        <source>See and change the keys</source>
        <translation>Vedi e cambia le scorciatoie</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>Tema sc&amp;uro</translation>
    </message>
    <message>
        <source>Light text on a dark background</source>
        <translation>Testo chiaro su fondo scuro</translation>
    </message>
    <message>
        <source>P&amp;icture…</source>
        <translation>&amp;Immagine…</translation>
    </message>
    <message>
        <source>Save the viewport as a PNG</source>
        <translation>Salva la vista come PNG</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>Schermo &amp;intero</translation>
    </message>
    <message>
        <source>The whole screen</source>
        <translation>Tutto lo schermo</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Scorciatoie</translation>
    </message>
    <message>
        <source>All keys at a glance</source>
        <translation>Tutte le scorciatoie</translation>
    </message>
    <message>
        <source>Show &amp;log</source>
        <translation>Mostra il &amp;registro</translation>
    </message>
    <message>
        <source>Files opened, plans, findings and errors</source>
        <translation>File aperti, piani, segnalazioni ed errori</translation>
    </message>
    <message>
        <source>&amp;About Voluta</source>
        <translation>&amp;Informazioni su Voluta</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Versione e licenza</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Confronta</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Esporta</translation>
    </message>
    <message>
        <source>Robot &amp;programs…</source>
        <translation>&amp;Programmi robot…</translation>
    </message>
    <message>
        <source>Write the chosen programs into a folder</source>
        <translation>Scrivi i programmi scelti in una cartella</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>&amp;Strati</translation>
    </message>
    <message>
        <source>Go to this page</source>
        <translation>Vai a questa pagina</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Sposta</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Ruota</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>S&amp;cala</translation>
    </message>
    <message>
        <source>&amp;Lay on face</source>
        <translation>&amp;Appoggia su faccia</translation>
    </message>
    <message>
        <source>Click the face to place on the plate</source>
        <translation>Fai clic sulla faccia da appoggiare sul piatto</translation>
    </message>
    <message>
        <source>&amp;Drop to plate</source>
        <translation>Abbassa sul &amp;piatto</translation>
    </message>
    <message>
        <source>Lowers the part onto the plate</source>
        <translation>Abbassa il pezzo sul piatto</translation>
    </message>
    <message>
        <source>&amp;Centre</source>
        <translation>C&amp;entra</translation>
    </message>
    <message>
        <source>Centres the part on the plate</source>
        <translation>Centra il pezzo sul piatto</translation>
    </message>
    <message>
        <source>Place on touched &amp;points…</source>
        <translation>Posa su &amp;punti toccati…</translation>
    </message>
    <message>
        <source>Moves the part to a cylinder measured by touching</source>
        <translation>Porta il pezzo su un cilindro misurato toccandolo</translation>
    </message>
    <message>
        <source>&amp;Prepare</source>
        <translation>&amp;Prepara</translation>
    </message>
    <message>
        <source>Reset all &amp;parameters</source>
        <translation>Ripristina &amp;tutti i parametri</translation>
    </message>
    <message>
        <source>Resets every parameter to its default</source>
        <translation>Riporta ogni parametro al valore predefinito</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>Si&amp;mula</translation>
    </message>
    <message>
        <source>&amp;New project</source>
        <translation>&amp;Nuovo progetto</translation>
    </message>
    <message>
        <source>Start without a part</source>
        <translation>Comincia senza pezzo</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Apri…</translation>
    </message>
    <message>
        <source>Open a mesh or a project</source>
        <translation>Apri una mesh o un progetto</translation>
    </message>
    <message>
        <source>Vase</source>
        <translation>Vaso</translation>
    </message>
    <message>
        <source>A fluted vase, 60 mm high</source>
        <translation>Un vaso scanalato alto 60 mm</translation>
    </message>
    <message>
        <source>Mushroom</source>
        <translation>Fungo</translation>
    </message>
    <message>
        <source>A wide cap on a stem, made of voxels</source>
        <translation>Un cappello largo su un gambo, fatto di voxel</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>Forca</translation>
    </message>
    <message>
        <source>A stem with two branches, made of voxels</source>
        <translation>Un gambo con due rami, fatto di voxel</translation>
    </message>
    <message>
        <source>Dumb-bell for tension</source>
        <translation>Provino di trazione</translation>
    </message>
    <message>
        <source>A specimen of 165 × 19 × 3 mm</source>
        <translation>Un provino di 165 × 19 × 3 mm</translation>
    </message>
    <message>
        <source>Bar for bending</source>
        <translation>Barra di flessione</translation>
    </message>
    <message>
        <source>A specimen of 250 × 10 × 5 mm</source>
        <translation>Un provino di 250 × 10 × 5 mm</translation>
    </message>
    <message>
        <source>Plate with a hole</source>
        <translation>Piastra forata</translation>
    </message>
    <message>
        <source>A specimen of 120 × 60 × 3 mm</source>
        <translation>Un provino di 120 × 60 × 3 mm</translation>
    </message>
    <message>
        <source>Curved bar on its mould</source>
        <translation>Barra curva sul suo stampo</translation>
    </message>
    <message>
        <source>Seven layers around a cylinder of 60 mm radius</source>
        <translation>Sette strati attorno a un cilindro di raggio 60 mm</translation>
    </message>
    <message>
        <source>Rib on a gable roof</source>
        <translation>Nervatura su un tetto a due falde</translation>
    </message>
    <message>
        <source>Ten layers over both slopes; the nozzle tilts by 60°</source>
        <translation>Dieci strati sulle due falde; l&apos;ugello si inclina di 60°</translation>
    </message>
    <message>
        <source>Rib on a half cylinder</source>
        <translation>Nervatura su un mezzo cilindro</translation>
    </message>
    <message>
        <source>Ten layers around it; the nozzle tilts by 87°</source>
        <translation>Dieci strati attorno ad esso; l&apos;ugello si inclina di 87°</translation>
    </message>
    <message>
        <source>Accuracy plate</source>
        <translation>Piastra di precisione</translation>
    </message>
    <message>
        <source>Slots and a hole of known sizes, to be measured</source>
        <translation>Cave e un foro di misure note, da misurare</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salva</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Salva il progetto</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Salva con n&amp;ome…</translation>
    </message>
    <message>
        <source>Save the project under a new name</source>
        <translation>Salva il progetto con un altro nome</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Pianifica</translation>
    </message>
    <message>
        <source>From the part to verified robot programs</source>
        <translation>Dal pezzo ai programmi robot verificati</translation>
    </message>
    <message>
        <source>Plan up to the &amp;layers</source>
        <translation>Pianifica fino agli &amp;strati</translation>
    </message>
    <message>
        <source>Stops before tool-paths and motion</source>
        <translation>Si ferma prima di percorsi utensile e movimento</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Interrompi</translation>
    </message>
    <message>
        <source>Stop; the last results stay visible</source>
        <translation>Ferma; gli ultimi risultati restano in vista</translation>
    </message>
    <message>
        <source>&amp;Update voxels while editing</source>
        <translation>&amp;Aggiorna i voxel mentre si modifica</translation>
    </message>
    <message>
        <source>After the first plan, voxels follow the settings; layers and paths wait for Plan</source>
        <translation>Dopo il primo piano i voxel seguono le impostazioni; strati e percorsi attendono Pianifica</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Fronte</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Retro</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Destra</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Sinistra</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>So&amp;pra</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>S&amp;otto</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>Obli&amp;qua</translation>
    </message>
    <message>
        <source>View from this side</source>
        <translation>Guarda da questo lato</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;File</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Modifica</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vista</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Esegui</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;sporta</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Fi&amp;nestra</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aiuto</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Apri &amp;recenti</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>&amp;Esempi</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Lingua</translation>
    </message>
    <message>
        <source>Show &amp;everything</source>
        <translation>Mostra &amp;tutto</translation>
    </message>
    <message>
        <source>Fit everything into the view</source>
        <translation>Adatta tutto alla vista</translation>
    </message>
    <message>
        <source>&amp;Section plane</source>
        <translation>Piano di se&amp;zione</translation>
    </message>
    <message>
        <source>Cut the view open with a plane</source>
        <translation>Apri la vista con un piano di taglio</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>&amp;Legenda</translation>
    </message>
    <message>
        <source>Meaning of the colours in the view</source>
        <translation>Significato dei colori nella vista</translation>
    </message>
    <message>
        <source>&amp;Unrolled layer</source>
        <translation>Strato &amp;srotolato</translation>
    </message>
    <message>
        <source>Shows layers around an axis unrolled, next to the view</source>
        <translation>Mostra gli strati intorno a un asse srotolati, accanto alla vista</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Avvia o metti in pausa</translation>
    </message>
    <message>
        <source>Play or pause the time-line</source>
        <translation>Avvia o ferma la simulazione</translation>
    </message>
    <message>
        <source>Next move</source>
        <translation>Movimento successivo</translation>
    </message>
    <message>
        <source>One move forward</source>
        <translation>Avanti di un movimento</translation>
    </message>
    <message>
        <source>Previous move</source>
        <translation>Movimento precedente</translation>
    </message>
    <message>
        <source>One move back</source>
        <translation>Indietro di un movimento</translation>
    </message>
    <message>
        <source>Next layer</source>
        <translation>Strato successivo</translation>
    </message>
    <message>
        <source>One layer forward</source>
        <translation>Avanti di uno strato</translation>
    </message>
    <message>
        <source>Previous layer</source>
        <translation>Strato precedente</translation>
    </message>
    <message>
        <source>One layer back</source>
        <translation>Indietro di uno strato</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Salva l&apos;immagine</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Immagini (*.png)</translation>
    </message>
    <message>
        <source>About Voluta</source>
        <translation>Informazioni su Voluta</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Voluta %1&lt;/h3&gt;&lt;p&gt;3D printing with robot arms: layers without support, tool-paths, motion checked against the growing part, and programs verified by replay.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Voluta %1&lt;/h3&gt;&lt;p&gt;Stampa 3D con bracci robot: strati senza supporto, percorsi utensile, movimento controllato rispetto al pezzo che cresce e programmi verificati rieseguendoli.&lt;/p&gt;&lt;p&gt;Software libero con licenza GNU General Public License, versione 3 o successiva.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Annulla: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Ripeti: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ripeti</translation>
    </message>
    <message>
        <source>&amp;Resume print from here…</source>
        <translation>&amp;Riprendi la stampa da qui…</translation>
    </message>
    <message>
        <source>Opens the rest of a print stopped at this moment as a new project</source>
        <translation>Apre come nuovo progetto il resto di una stampa interrotta in questo momento</translation>
    </message>
    <message>
        <source>&amp;Verify a program…</source>
        <translation>&amp;Verifica un programma…</translation>
    </message>
    <message>
        <source>Replay a program from disk against the plan shown</source>
        <translation>Esegui di prova un programma da disco e confrontalo con il piano mostrato</translation>
    </message>
    <message>
        <source>Edit &amp;cell…</source>
        <translation>Modifica &amp;cella…</translation>
    </message>
    <message>
        <source>Robot, and positions of nozzle, plate and obstacles</source>
        <translation>Robot e posizioni di ugello, piatto e ostacoli</translation>
    </message>
    <message>
        <source>Import robot &amp;arm…</source>
        <translation>Importa &amp;braccio robotico…</translation>
    </message>
    <message>
        <source>Your own robot from its URDF, with a cell</source>
        <translation>Un robot proprio, dal suo URDF, con una cella</translation>
    </message>
    <message>
        <source>D&amp;uplicate part</source>
        <translation>D&amp;uplica pezzo</translation>
    </message>
    <message>
        <source>Adds a copy of the selected part beside the others</source>
        <translation>Aggiunge una copia del pezzo scelto accanto agli altri</translation>
    </message>
    <message>
        <source>&amp;Remove part</source>
        <translation>&amp;Rimuovi pezzo</translation>
    </message>
    <message>
        <source>A&amp;dd part…</source>
        <translation>Aggiungi pe&amp;zzo…</translation>
    </message>
    <message>
        <source>Adds a part beside the others</source>
        <translation>Aggiunge un pezzo accanto agli altri</translation>
    </message>
    <message>
        <source>&amp;Arrange parts</source>
        <translation>&amp;Disponi i pezzi</translation>
    </message>
    <message>
        <source>Moves all parts beside each other, with room for the print head</source>
        <translation>Mette tutti i pezzi uno accanto all&apos;altro, con spazio per la testa di stampa</translation>
    </message>
    <message>
        <source>Processes and &amp;materials…</source>
        <translation>Processi e &amp;materiali…</translation>
    </message>
    <message>
        <source>Nozzle, bead sizes, speeds, head; own processes and materials</source>
        <translation>Ugello, misure dei cordoni, velocità, testina; processi e materiali propri</translation>
    </message>
    <message>
        <source>Compare with a recor&amp;ded run…</source>
        <translation>Confronta con un&apos;esecuzione regis&amp;trata…</translation>
    </message>
    <message>
        <source>Lays a run that the controller recorded beside the plan shown</source>
        <translation>Affianca al piano mostrato un&apos;esecuzione registrata dal controllore</translation>
    </message>
    <message>
        <source>&amp;Mill from a block…</source>
        <translation>&amp;Fresa da un blocco…</translation>
    </message>
    <message>
        <source>Mills the part out of a block and writes the G-code, checked on the block</source>
        <translation>Ricava il pezzo da un blocco per fresatura e scrive il G-code, verificato sul blocco</translation>
    </message>
    <message>
        <source>Print to&amp;gether with other machines…</source>
        <translation>Stampa insie&amp;me ad altre macchine…</translation>
    </message>
    <message>
        <source>Places other machines beside this one and finds an order of work in which they do not meet</source>
        <translation>Posiziona altre macchine accanto a questa e trova un ordine di lavoro in cui non si urtano</translation>
    </message>
    <message>
        <source>Moves the part: drag a handle, or type X 10 Enter</source>
        <translation>Sposta il pezzo: trascina una maniglia, o scrivi X 10 Invio</translation>
    </message>
    <message>
        <source>Rotates the part: drag a ring, or type Z 45 Enter</source>
        <translation>Ruota il pezzo: trascina un anello, o scrivi Z 45 Invio</translation>
    </message>
    <message>
        <source>Scales the part: drag a handle, or type 120 Enter for 120 %</source>
        <translation>Scala il pezzo: trascina una maniglia, o scrivi 120 Invio per il 120 %</translation>
    </message>
    <message>
        <source>Removes the selected parts from the plate</source>
        <translation>Toglie dal piatto i pezzi scelti</translation>
    </message>
    <message>
        <source>&amp;Number of copies…</source>
        <translation>&amp;Numero di copie…</translation>
    </message>
    <message>
        <source>Prints the selected part several times, or as often as the plate has room</source>
        <translation>Stampa più volte il pezzo scelto, o quante volte c&apos;è posto sul piatto</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copia</translation>
    </message>
    <message>
        <source>Copies the selected parts with their settings</source>
        <translation>Copia i pezzi scelti con le loro impostazioni</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Incolla</translation>
    </message>
    <message>
        <source>Adds the copied parts beside the others</source>
        <translation>Aggiunge i pezzi copiati accanto agli altri</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Seleziona &amp;tutto</translation>
    </message>
    <message>
        <source>Selects all parts, to copy or to remove them</source>
        <translation>Seleziona tutti i pezzi, per copiarli o toglierli</translation>
    </message>
    <message>
        <source>Show the &amp;part</source>
        <translation>Mostra il &amp;pezzo</translation>
    </message>
    <message>
        <source>Fit the selected part into the view</source>
        <translation>Adatta il pezzo scelto alla vista</translation>
    </message>
    <message>
        <source>Show the &amp;arm</source>
        <translation>Mostra il &amp;braccio</translation>
    </message>
    <message>
        <source>On the Prepare page, shows the arm whole instead of dimmed behind the part</source>
        <translation>Nella pagina Prepara mostra il braccio intero invece che attenuato dietro il pezzo</translation>
    </message>
    <message>
        <source>&amp;Find a command or setting…</source>
        <translation>&amp;Trova un comando o un&apos;impostazione…</translation>
    </message>
    <message>
        <source>Lists commands and settings while you type</source>
        <translation>Elenca comandi e impostazioni mentre scrivi</translation>
    </message>
    <message>
        <source>&amp;Quote…</source>
        <translation>&amp;Preventivo…</translation>
    </message>
    <message>
        <source>Cost of the print, and its page for a customer</source>
        <translation>Costo della stampa, e la sua pagina per un cliente</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuale</translation>
    </message>
    <message>
        <source>The page of the manual about what is shown</source>
        <translation>La pagina del manuale su ciò che è mostrato</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>Es&amp;porta…</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>M&amp;isura</translation>
    </message>
    <message>
        <source>Click places on the part: radius, wall, distance, angle</source>
        <translation>Fai clic sul pezzo: raggio, parete, distanza, angolo</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Chiaro</translation>
    </message>
    <message>
        <source>Dark text on a light background</source>
        <translation>Testo scuro su sfondo chiaro</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Contrasto &amp;elevato</translation>
    </message>
    <message>
        <source>White text on black, with strong outlines</source>
        <translation>Testo bianco su nero, con contorni marcati</translation>
    </message>
    <message>
        <source>&amp;Film…</source>
        <translation>&amp;Filmato…</translation>
    </message>
    <message>
        <source>Save a film of the robot that prints the part (WebM)</source>
        <translation>Salva un filmato del robot che stampa il pezzo (WebM)</translation>
    </message>
    <message>
        <source>C&amp;ut…</source>
        <translation>&amp;Taglia…</translation>
    </message>
    <message>
        <source>Cuts the part in two with a plane, with dowels, pegs or a dovetail</source>
        <translation>Taglia il pezzo in due con un piano, con spine, perni o una coda di rondine</translation>
    </message>
    <message>
        <source>Split to &amp;parts</source>
        <translation>Separa in &amp;pezzi</translation>
    </message>
    <message>
        <source>Makes a part of each body of the mesh</source>
        <translation>Fa un pezzo di ogni corpo della mesh</translation>
    </message>
    <message>
        <source>Re&amp;name part</source>
        <translation>Ri&amp;nomina pezzo</translation>
    </message>
    <message>
        <source>Edits the name of the part in the tree</source>
        <translation>Modifica il nome del pezzo nell&apos;albero</translation>
    </message>
    <message>
        <source>Loo&amp;k</source>
        <translation>Aspe&amp;tto</translation>
    </message>
    <message>
        <source>Darken cor&amp;ners</source>
        <translation>Scurisci gli an&amp;goli</translation>
    </message>
    <message>
        <source>Darkens corners and gaps, so that shapes are clearer; slow without a graphics card</source>
        <translation>Scurisce angoli e fessure, così le forme si vedono meglio; lento senza scheda grafica</translation>
    </message>
    <message>
        <source>Re&amp;gions…</source>
        <translation>Re&amp;gioni…</translation>
    </message>
    <message>
        <source>Places in the part with settings, or layers, of their own</source>
        <translation>Punti del pezzo con impostazioni, o strati, propri</translation>
    </message>
    <message>
        <source>Add &amp;region…</source>
        <translation>Aggiungi &amp;regione…</translation>
    </message>
    <message>
        <source>Adds a place with settings, or layers, of its own</source>
        <translation>Aggiunge un punto con impostazioni, o strati, propri</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>&quot;{text}&quot; is not a point</source>
        <translation>&quot;{text}&quot; non è un punto</translation>
    </message>
    <message>
        <source>&apos;end&apos; closes no function</source>
        <translation>&apos;end&apos; non chiude alcuna funzione</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not a number</source>
        <translation>&apos;{attribute}&apos; non è un numero</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not an integer</source>
        <translation>&apos;{attribute}&apos; non è un numero intero</translation>
    </message>
    <message>
        <source>&apos;{corner}&apos; is not the index of a vertex</source>
        <translation>&apos;{corner}&apos; non è l&apos;indice di un vertice</translation>
    </message>
    <message>
        <source>&apos;{corner}&apos; is not the index of a vertex read so far</source>
        <translation>&apos;{corner}&apos; non è l&apos;indice di un vertice già letto</translation>
    </message>
    <message>
        <source>&apos;{loaded}&apos; is not unloaded</source>
        <translation>&apos;{loaded}&apos; non viene scaricato</translation>
    </message>
    <message>
        <source>&apos;{member}&apos; in it {what}</source>
        <translation>&apos;{member}&apos; al suo interno {what}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is called outside the function</source>
        <translation>&apos;{name}&apos; è chiamato fuori dalla funzione</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not of type {type}</source>
        <translation>&apos;{name}&apos; non è di tipo {type}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not declared as {type}</source>
        <translation>&apos;{name}&apos; non è dichiarato come {type}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not known to the reader</source>
        <translation>&apos;{name}&apos; non è noto al lettore</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a weight</source>
        <translation>&apos;{text}&apos; non è un peso</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a number</source>
        <translation>&apos;{text}&apos; non è un numero</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not expected here</source>
        <translation>&apos;{text}&apos; non è atteso qui</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not key=value</source>
        <translation>&apos;{text}&apos; non è chiave=valore</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is neither true nor false</source>
        <translation>&apos;{value}&apos; non è né true né false</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not a number</source>
        <translation>&apos;{value}&apos; non è un numero</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not a whole number</source>
        <translation>&apos;{value}&apos; non è un numero intero</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not one of {choices}</source>
        <translation>&apos;{value}&apos; non è tra {choices}</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is out of range</source>
        <translation>&apos;{value}&apos; è fuori dall&apos;intervallo</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not known to the reader</source>
        <translation>&apos;{word}&apos; non è noto al lettore</translation>
    </message>
    <message>
        <source>--ik: the quaternion&apos;s length is {length:.4g}, not 1</source>
        <translation>--ik: la lunghezza del quaternione è {length:.4g}, non 1</translation>
    </message>
    <message>
        <source>0: round rod. 3 or more: prism; its diameter is measured across the corners.</source>
        <translation>0: barra tonda. 3 o più: prisma; il diametro si misura sugli spigoli.</translation>
    </message>
    <message>
        <source>Adaptive layers: largest distance between the edges of layers and the surface.</source>
        <translation>Strati adattivi: distanza massima tra i bordi degli strati e la superficie.</translation>
    </message>
    <message>
        <source>Adds voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, toolpath.vtp and trajectory.csv.</source>
        <translation>Aggiunge voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, toolpath.vtp e trajectory.csv.</translation>
    </message>
    <message>
        <source>Also writes programs that the replay refused, as refused-NAME. For inspection only: never run them.</source>
        <translation>Scrive anche i programmi respinti dalla verifica, come refused-NOME: da esaminare, mai da eseguire.</translation>
    </message>
    <message>
        <source>Beads along circles are written as arcs (G2 and G3, movec, MoveC, CIRC), within the resolution or 0.02 mm.</source>
        <translation>I cordoni lungo cerchi si scrivono come archi (G2 e G3, movec, MoveC, CIRC), entro la risoluzione o 0,02 mm.</translation>
    </message>
    <message>
        <source>Layers at constant radius around the axis, or at constant distance from the rod&apos;s profile.</source>
        <translation>Strati a raggio costante intorno all’asse, o a distanza costante dal profilo della barra.</translation>
    </message>
    <message>
        <source>Beads</source>
        <translation>cordoni</translation>
    </message>
    <message>
        <source>an arc on a table that tilts is not understood</source>
        <translation>un arco su una tavola che si inclina non è compreso</translation>
    </message>
    <message>
        <source>export straight lines</source>
        <translation>esporta linee rette</translation>
    </message>
    <message>
        <source>Number of beads along the outline of each layer.</source>
        <translation>Numero di cordoni lungo il contorno di ogni strato.</translation>
    </message>
    <message>
        <source>Colli-
sions</source>
        <translation>Colli-
sioni</translation>
    </message>
    <message>
        <source>Convex front</source>
        <translation>Fronte convesso</translation>
    </message>
    <message>
        <source>Decomposition</source>
        <translation>Scomposizione</translation>
    </message>
    <message>
        <source>Direction of straight lines on the first layer, measured from x to y.</source>
        <translation>Direzione delle linee rette sul primo strato, misurata da x verso y.</translation>
    </message>
    <message>
        <source>Minimum distance of everything but the print head from printed material.</source>
        <translation>Distanza minima dal materiale stampato per tutto tranne la testa di stampa.</translation>
    </message>
    <message>
        <source>Minimum distance between links, plate, nozzle holder and obstacles.</source>
        <translation>Distanza minima fra membri del braccio, piatto, portaugello e ostacoli.</translation>
    </message>
    <message>
        <source>ENDMODULE is missing: the file was cut short</source>
        <translation>manca ENDMODULE: il file è stato troncato</translation>
    </message>
    <message>
        <source>ENDPROC without a procedure</source>
        <translation>ENDPROC senza procedura</translation>
    </message>
    <message>
        <source>Fermat spiral</source>
        <translation>spirale di Fermat</translation>
    </message>
    <message>
        <source>Field rounds</source>
        <translation>cicli del campo</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>fronte</translation>
    </message>
    <message>
        <source>Gap fill</source>
        <translation>Riempimento vuoti</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppo</translation>
    </message>
    <message>
        <source>Growth step</source>
        <translation>Passo di crescita</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altezza</translation>
    </message>
    <message>
        <source>Largest overhang, measured from the vertical, that prints without support; in all modes except curved.</source>
        <translation>Sbalzo massimo, misurato dalla verticale, che si stampa senza supporto; in tutti i modi tranne quello curvo.</translation>
    </message>
    <message>
        <source>Minimum distance by which the nozzle lifts off the part before it travels.</source>
        <translation>Distanza minima di cui l&apos;ugello si stacca dal pezzo prima di spostarsi a vuoto.</translation>
    </message>
    <message>
        <source>How many rotations of the part about the nozzle&apos;s axis are tried at each point.</source>
        <translation>Quante rotazioni del pezzo attorno all&apos;asse dell&apos;ugello vengono provate in ogni punto.</translation>
    </message>
    <message>
        <source>Points of beads are omitted if the path, the nozzle&apos;s direction, the bead&apos;s section and the speed stay within tolerance without them; this is the tolerance of the path. 0: all points are written. Cells with external axes keep all points.</source>
        <translation>I punti dei cordoni vengono omessi se senza di essi il percorso, la direzione dell&apos;ugello, la sezione del cordone e la velocità restano entro la tolleranza; questa è la tolleranza del percorso. 0: si scrivono tutti i punti. Le celle con assi esterni mantengono tutti i punti.</translation>
    </message>
    <message>
        <source>Rotation of straight lines from layer to layer; 0: the same direction throughout.</source>
        <translation>Rotazione delle linee rette da uno strato all’altro; 0: sempre la stessa direzione.</translation>
    </message>
    <message>
        <source>Maximum number of rounds that fit the growth order and the smooth field to each other. 0: layers follow the growth order.</source>
        <translation>Numero massimo di passate che adattano l&apos;uno all&apos;altro l&apos;ordine di crescita e il campo liscio. 0: gli strati seguono l&apos;ordine di crescita.</translation>
    </message>
    <message>
        <source>Pattern that fills the interior of each layer.</source>
        <translation>Motivo che riempie l&apos;interno di ogni strato.</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>Riempimento</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Strato</translation>
    </message>
    <message>
        <source>Layer spacing</source>
        <translation>Spaziatura degli strati</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Strati</translation>
    </message>
    <message>
        <source>Surface on which flattening layers end: flat (at the part&apos;s top), flat:Z, radius:R (a larger cylinder) or mesh:FILE, placed together with the platform&apos;s mesh.</source>
        <translation>Superficie su cui finiscono gli strati che si spianano: flat (in cima al pezzo), flat:Z, radius:R (un cilindro più largo) o mesh:FILE, posato insieme alla mesh della piattaforma.</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Caricamento</translation>
    </message>
    <message>
        <source>Missed, cascade</source>
        <translation>Mancati, a cascata</translation>
    </message>
    <message>
        <source>Missed, shadowed</source>
        <translation>Mancati, in ombra</translation>
    </message>
    <message>
        <source>Missed, unreached</source>
        <translation>Mancati, non raggiunti</translation>
    </message>
    <message>
        <source>Mode flat: a JSON file or JSON text with the plane or quadrilateral of each layer. Empty: horizontal layers.</source>
        <translation>Modo flat: un file JSON o un testo JSON con il piano o quadrilatero di ogni strato. Vuoto: strati orizzontali.</translation>
    </message>
    <message>
        <source>Mode planar: a JSON file or JSON text with a point and a normal for each cutting plane, in cutting order. Empty: automatic.</source>
        <translation>Modo planar: un file JSON o un testo JSON con un punto e una normale per ogni piano di taglio, in ordine di taglio. Vuoto: automatico.</translation>
    </message>
    <message>
        <source>Mode planar: materials or filaments of the pieces, separated by commas. The list starts over if there are more pieces. Empty: the process&apos;s material.</source>
        <translation>Modo planar: i materiali o filamenti dei pezzi, separati da virgole. Si ricomincia dal primo se i pezzi sono di più. Vuoto: il materiale del processo.</translation>
    </message>
    <message>
        <source>Mode planar: beam is a beam search that checks the true shape of the head; greedy is the published scheme, based on the part&apos;s skeleton.</source>
        <translation>Modo planar: beam è una ricerca a fascio che verifica la vera forma della testa; greedy è lo schema pubblicato, basato sullo scheletro del pezzo.</translation>
    </message>
    <message>
        <source>Mode substrate: layers at constant distance from the surface, on spheres, on cylinders along x, or flattening from the surface to an end surface with varying thickness.</source>
        <translation>Modo substrate: strati a distanza costante dalla superficie, su sfere, su cilindri lungo x, o che si spianano dalla superficie a una superficie finale con spessore variabile.</translation>
    </message>
    <message>
        <source>Height of the first layer; in all modes except curved. 0: same as the other layers.</source>
        <translation>Altezza del primo strato; in tutti i modi tranne curved. 0: come gli altri strati.</translation>
    </message>
    <message>
        <source>Modes planar and flat: thinner layers where the surface is inclined, within the process&apos;s limits.</source>
        <translation>Modi planar e flat: strati più sottili dove la superficie è inclinata, entro i limiti del processo.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimento</translation>
    </message>
    <message>
        <source>Needs support</source>
        <translation>Richiede supporto</translation>
    </message>
    <message>
        <source>For helical infill: 0 winds around the axis, 90 runs along it.</source>
        <translation>Per il riempimento elicoidale: 0 si avvolge attorno all&apos;asse, 90 corre lungo l&apos;asse.</translation>
    </message>
    <message>
        <source>Centre of spheres and cylinders: x,y,z in mm. Empty: that of the sphere or cylinder below the part, or a point below the part.</source>
        <translation>Centro di sfere e cilindri: x,y,z in mm. Vuoto: quello della sfera o del cilindro su cui sta il pezzo, o un punto sotto il pezzo.</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>file in uscita</translation>
    </message>
    <message>
        <source>Pairs of x and radius in mm, such as -20,2.5 0,2.5 0,3.5 20,3.5, or a file with such pairs. A step needs two pairs at the same x. Beyond the pairs the rod keeps its own diameter. Empty: straight.</source>
        <translation>Coppie di x e raggio in mm, come -20,2.5 0,2.5 0,3.5 20,3.5, o un file che le contiene. Un gradino richiede due coppie alla stessa x. Oltre, la barra mantiene il proprio diametro. Vuoto: diritta.</translation>
    </message>
    <message>
        <source>Peeling rank</source>
        <translation>Rango di pelatura</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pezzi</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>RAPID (ABB)</source>
        <translation>RAPID (ABB)</translation>
    </message>
    <message>
        <source>Reach
%</source>
        <translation>Porta-
ta %</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Verifica</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Barra</translation>
    </message>
    <message>
        <source>Scheme greedy: number of thickness classes that distinguish the part&apos;s branches. 0: automatic.</source>
        <translation>Schema greedy: numero di classi di spessore che distinguono i rami del pezzo. 0: automatico.</translation>
    </message>
    <message>
        <source>Scheme greedy: a point x,y,z (mm) on the piece to print first; that piece must touch the plate. Empty: the piece with the largest contact area.</source>
        <translation>Schema greedy: un punto x,y,z (mm) sul pezzo da stampare per primo, che deve toccare la piastra. Vuoto: quello con l’area di contatto maggiore.</translation>
    </message>
    <message>
        <source>Head shape that must clear the part printed so far. flat: a plate of unlimited width. nozzle: the real head where voxels would be lost otherwise, and under wide roofs. auto: the real head only under wide roofs.</source>
        <translation>Forma della testa che non deve urtare il pezzo già stampato. flat: una piastra di larghezza illimitata. nozzle: la testa vera dove altrimenti si perderebbero voxel, e sotto tetti larghi. auto: la testa vera solo sotto tetti larghi.</translation>
    </message>
    <message>
        <source>Skirt or brim</source>
        <translation>Skirt o brim</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocità</translation>
    </message>
    <message>
        <source>Current growth step</source>
        <translation>Passo di crescita attuale</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Supporto</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>supporti</translation>
    </message>
    <message>
        <source>Supports
mm³</source>
        <translation>Supporti
mm³</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Tilt of the nozzle</source>
        <translation>Inclinazione dell&apos;ugello</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Too thick to print</source>
        <translation>Troppo spesso da stampare</translation>
    </message>
    <message>
        <source>Too thin to print</source>
        <translation>Troppo sottile da stampare</translation>
    </message>
    <message>
        <source>Tool-paths</source>
        <translation>Percorsi utensile</translation>
    </message>
    <message>
        <source>URScript (Universal Robots)</source>
        <translation>URScript (Universal Robots)</translation>
    </message>
    <message>
        <source>Use voxel width {fits}</source>
        <translation>Usa voxel larghi {fits}</translation>
    </message>
    <message>
        <source>Voxel width</source>
        <translation>larghezza voxel</translation>
    </message>
    <message>
        <source>WaitTime without a time in seconds</source>
        <translation>WaitTime senza un tempo in secondi</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Parete</translation>
    </message>
    <message>
        <source>Nominal layer height; limited by the process.</source>
        <translation>Altezza nominale di uno strato; il processo ne fissa i limiti.</translation>
    </message>
    <message>
        <source>Nominal bead width; limited by the process.</source>
        <translation>Larghezza nominale di un cordone; il processo ne fissa i limiti.</translation>
    </message>
    <message>
        <source>The axis of the part that is aligned with the rod. auto: the axis parallel to its sides.</source>
        <translation>L’asse del pezzo che si allinea alla barra. auto: quello parallelo ai suoi fianchi.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Voxel width used for growth; the layer height is independent of it.</source>
        <translation>Larghezza dei voxel usati per la crescita; l&apos;altezza degli strati non ne dipende.</translation>
    </message>
    <message>
        <source>an arc from a position that is not known</source>
        <translation>un arco da una posizione non nota</translation>
    </message>
    <message>
        <source>an arc that changes its height is not understood</source>
        <translation>un arco che cambia altezza non è supportato</translation>
    </message>
    <message>
        <source>an arc without its centre, I and J</source>
        <translation>un arco senza il suo centro, I e J</translation>
    </message>
    <message>
        <source>arc fitting</source>
        <translation>adattamento ad archi</translation>
    </message>
    <message>
        <source>choose the process that the file was sliced for, or slice it with beads of this process</source>
        <translation>scegli il processo per cui il file è stato preparato, oppure preparalo con cordoni di questo processo</translation>
    </message>
    <message>
        <source>movec needs two poses</source>
        <translation>movec richiede due pose</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>risoluzione</translation>
    </message>
    <message>
        <source>the end of an arc is not at the distance of its start from the centre</source>
        <translation>la fine di un arco non ha la stessa distanza dal centro del suo inizio</translation>
    </message>
    <message>
        <source>the file heats {heat}: programs heat as the material states, choose one that fits</source>
        <translation>il file scalda a {heat}: i programmi scaldano come indica il materiale, scegline uno adatto</translation>
    </message>
    <message>
        <source>the three points of an arc are on a line</source>
        <translation>i tre punti di un arco sono allineati</translation>
    </message>
    <message>
        <source>unknown G command</source>
        <translation>comando G sconosciuto</translation>
    </message>
    <message>
        <source>a PLY file begins with &quot;ply&quot;</source>
        <translation>un file PLY comincia con &quot;ply&quot;</translation>
    </message>
    <message>
        <source>a call of a module that is not loaded</source>
        <translation>una chiamata a un modulo non caricato</translation>
    </message>
    <message>
        <source>support column of {voxels} from {foot}: it carries {carried} that would be missed</source>
        <translation>colonna di supporto di {voxels} da {foot}: porta {carried} che altrimenti mancherebbero</translation>
    </message>
    <message>
        <source>a configuration that is not in whole quarter turns</source>
        <translation>una configurazione che non è in quarti di giro interi</translation>
    </message>
    <message>
        <source>a digital output must be 0 or 1</source>
        <translation>un&apos;uscita digitale dev&apos;essere 0 o 1</translation>
    </message>
    <message>
        <source>a direction needs nX, nY and nZ</source>
        <translation>una direzione richiede nX, nY e nZ</translation>
    </message>
    <message>
        <source>a direction is not a unit vector</source>
        <translation>una direzione non è un vettore unitario</translation>
    </message>
    <message>
        <source>a face refers to vertex {vertex} of {vertices}</source>
        <translation>una faccia indica il vertice {vertex} di {vertices}</translation>
    </message>
    <message>
        <source>a face needs its number of corners, then the corners</source>
        <translation>una faccia richiede il numero dei suoi vertici, poi i vertici</translation>
    </message>
    <message>
        <source>a face needs at least three corners</source>
        <translation>una faccia richiede almeno tre vertici</translation>
    </message>
    <message>
        <source>a facet with fewer than three vertices</source>
        <translation>una faccetta con meno di tre vertici</translation>
    </message>
    <message>
        <source>flow of {flow:.1f}, above the extruder&apos;s limit of {limit:.1f#}</source>
        <translation>flusso di {flow:.1f}, oltre il limite dell&apos;estrusore di {limit:.1f#}</translation>
    </message>
    <message>
        <source>a joint value far outside any limit</source>
        <translation>un valore di giunto molto oltre ogni limite</translation>
    </message>
    <message>
        <source>use a larger platform, or turn the part</source>
        <translation>usa una piattaforma più grande, o gira il pezzo</translation>
    </message>
    <message>
        <source>use a larger platform or supports, or join this piece to the part</source>
        <translation>usa una piattaforma più grande o supporti, o unisci questa parte al pezzo</translation>
    </message>
    <message>
        <source>a line does not end with CR LF</source>
        <translation>una riga non termina con CR LF</translation>
    </message>
    <message>
        <source>a line without a command</source>
        <translation>una riga senza comando</translation>
    </message>
    <message>
        <source>a list has an invalid length</source>
        <translation>una lista ha una lunghezza non valida</translation>
    </message>
    <message>
        <source>triangles with missing vertices</source>
        <translation>triangoli con vertici mancanti</translation>
    </message>
    <message>
        <source>a module must begin with MODULE and its name</source>
        <translation>un modulo deve cominciare con MODULE e il suo nome</translation>
    </message>
    <message>
        <source>a motion before X, Y and Z are all known</source>
        <translation>un movimento prima che X, Y e Z siano tutti noti</translation>
    </message>
    <message>
        <source>a motion before any speed (F)</source>
        <translation>un movimento prima di una velocità (F)</translation>
    </message>
    <message>
        <source>the motion never arrives: no speed or acceleration</source>
        <translation>il movimento non arriva mai: nessuna velocità o accelerazione</translation>
    </message>
    <message>
        <source>a motion with a word {letter} is not understood</source>
        <translation>un movimento con la parola {letter} non è compreso</translation>
    </message>
    <message>
        <source>a motion without a target</source>
        <translation>un movimento senza destinazione</translation>
    </message>
    <message>
        <source>a name is declared twice</source>
        <translation>un nome è dichiarato due volte</translation>
    </message>
    <message>
        <source>use a narrower bead or a lower layer height for fine detail, supports for areas that begin in the air</source>
        <translation>usa un cordone più stretto o strati più bassi per i dettagli fini, supporti per le zone che cominciano nel vuoto</translation>
    </message>
    <message>
        <source>a picture of {width} x {height} pixels cannot be drawn</source>
        <translation>un&apos;immagine di {width} x {height} pixel non può essere disegnata</translation>
    </message>
    <message>
        <source>a platform must be a mesh, not a voxel object</source>
        <translation>una piattaforma deve essere una mesh, non un oggetto di voxel</translation>
    </message>
    <message>
        <source>a point has NaN or infinite coordinates</source>
        <translation>un punto ha coordinate non numeriche o infinite</translation>
    </message>
    <message>
        <source>a point needs three numbers</source>
        <translation>un punto richiede tre numeri</translation>
    </message>
    <message>
        <source>point too far from the origin</source>
        <translation>punto troppo lontano dall&apos;origine</translation>
    </message>
    <message>
        <source>a pose before set_tcp: its TCP is unknown</source>
        <translation>una posa prima di set_tcp: il suo TCP non è noto</translation>
    </message>
    <message>
        <source>a pose far outside any robot&apos;s reach</source>
        <translation>una posa molto oltre la portata di ogni robot</translation>
    </message>
    <message>
        <source>a pose p[x,y,z,rx,ry,rz] is needed</source>
        <translation>serve una posa p[x,y,z,rx,ry,rz]</translation>
    </message>
    <message>
        <source>a position far outside any robot&apos;s reach</source>
        <translation>una posizione molto oltre la portata di ogni robot</translation>
    </message>
    <message>
        <source>a property of unknown type</source>
        <translation>una proprietà di tipo sconosciuto</translation>
    </message>
    <message>
        <source>a quadrilateral cannot cut a part</source>
        <translation>un quadrilatero non può tagliare un pezzo</translation>
    </message>
    <message>
        <source>a quadrilateral needs four corners</source>
        <translation>un quadrilatero richiede quattro vertici</translation>
    </message>
    <message>
        <source>a quaternion that is not normalised</source>
        <translation>un quaternione non normalizzato</translation>
    </message>
    <message>
        <source>a rod is round or has at least three sides</source>
        <translation>una barra è tonda o ha almeno tre lati</translation>
    </message>
    <message>
        <source>a rod needs at least two points</source>
        <translation>una barra richiede almeno due punti</translation>
    </message>
    <message>
        <source>row beyond the end of its array</source>
        <translation>riga oltre la fine del suo vettore</translation>
    </message>
    <message>
        <source>a second, different TCP</source>
        <translation>un secondo TCP, diverso</translation>
    </message>
    <message>
        <source>a second, different tool</source>
        <translation>un secondo utensile, diverso</translation>
    </message>
    <message>
        <source>a shifted origin is not understood</source>
        <translation>un&apos;origine spostata non è compresa</translation>
    </message>
    <message>
        <source>a space</source>
        <translation>uno spazio</translation>
    </message>
    <message>
        <source>an invalid speed</source>
        <translation>una velocità non valida</translation>
    </message>
    <message>
        <source>a speed that is not positive</source>
        <translation>una velocità non positiva</translation>
    </message>
    <message>
        <source>a statement outside the procedure</source>
        <translation>un&apos;istruzione fuori dalla procedura</translation>
    </message>
    <message>
        <source>a step at the end of the rod</source>
        <translation>un gradino all&apos;estremità della barra</translation>
    </message>
    <message>
        <source>target with fewer than six joints</source>
        <translation>destinazione con meno di sei giunti</translation>
    </message>
    <message>
        <source>an invalid time</source>
        <translation>un tempo non valido</translation>
    </message>
    <message>
        <source>a transform does not have twelve numbers</source>
        <translation>una trasformazione non ha dodici numeri</translation>
    </message>
    <message>
        <source>a transform contains a value that is not a number</source>
        <translation>una trasformazione contiene un valore che non è un numero</translation>
    </message>
    <message>
        <source>a triangle refers to the missing vertex {vertex}</source>
        <translation>un triangolo indica il vertice {vertex}, che non esiste</translation>
    </message>
    <message>
        <source>a vertex needs three numbers</source>
        <translation>un vertice richiede tre numeri</translation>
    </message>
    <message>
        <source>use a voxel width of at most {fits}</source>
        <translation>usa voxel larghi al massimo {fits}</translation>
    </message>
    <message>
        <source>wall {usual:.2f} thick ({thinnest:.2f} at its thinnest), thinner than a voxel of {voxel}</source>
        <translation>parete spessa {usual:.2f} ({thinnest:.2f} nel punto più sottile), più sottile di un voxel di {voxel}</translation>
    </message>
    <message>
        <source>a waypoint number has to be an integer of at least -1</source>
        <translation>il numero di un punto del percorso deve essere un intero di almeno -1</translation>
    </message>
    <message>
        <source>a work object must name the mechanical unit that moves it, or be stationary</source>
        <translation>un oggetto di lavoro deve indicare l&apos;unità meccanica che lo muove, o essere fermo</translation>
    </message>
    <message>
        <source>an invalid zone</source>
        <translation>una zona non valida</translation>
    </message>
    <message>
        <source>a zone for orientation or external axes smaller than the TCP&apos;s</source>
        <translation>una zona della rotazione o degli assi esterni più piccola di quella del TCP</translation>
    </message>
    <message>
        <source>a {type} must have other components</source>
        <translation>un {type} deve avere altri componenti</translation>
    </message>
    <message>
        <source>adaptive layers</source>
        <translation>strati adattivi</translation>
    </message>
    <message>
        <source>add a row of - under the part, where it should be placed</source>
        <translation>aggiungi una riga di - sotto il pezzo, dove deve poggiare</translation>
    </message>
    <message>
        <source>add supports (`supports=auto`), cut there, or use curved mode</source>
        <translation>aggiungi supporti (`supports=auto`), taglia lì, o usa strati curvi</translation>
    </message>
    <message>
        <source>along</source>
        <translation>lungo l&apos;asse</translation>
    </message>
    <message>
        <source>unknown M command</source>
        <translation>comando M sconosciuto</translation>
    </message>
    <message>
        <source>an OFF file begins with &quot;OFF&quot;</source>
        <translation>un file OFF comincia con &quot;OFF&quot;</translation>
    </message>
    <message>
        <source>an analogue output outside 0..1</source>
        <translation>un&apos;uscita analogica fuori da 0..1</translation>
    </message>
    <message>
        <source>an argument of {name} is unknown or given twice</source>
        <translation>un argomento di {name} è sconosciuto o dato due volte</translation>
    </message>
    <message>
        <source>an element needs its count</source>
        <translation>un elemento richiede il suo numero</translation>
    </message>
    <message>
        <source>an external axis far outside any limit</source>
        <translation>un asse esterno molto oltre ogni limite</translation>
    </message>
    <message>
        <source>an external axis that moves no work object is not supported</source>
        <translation>un asse esterno che non muove alcun oggetto di lavoro non è supportato</translation>
    </message>
    <message>
        <source>an output needs a number and a value</source>
        <translation>un&apos;uscita richiede un numero e un valore</translation>
    </message>
    <message>
        <source>an unknown PLY format</source>
        <translation>un formato PLY sconosciuto</translation>
    </message>
    <message>
        <source>an unknown line in the header</source>
        <translation>una riga sconosciuta nell&apos;intestazione</translation>
    </message>
    <message>
        <source>further defects from here on are not listed</source>
        <translation>altri errori da qui in poi non sono elencati</translation>
    </message>
    <message numerus="yes">
        <source>{count} more collisions</source>
        <translation>
            <numerusform>un&apos;altra collisione</numerusform>
            <numerusform>altre {count} collisioni</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} more violations</source>
        <translation>
            <numerusform>un&apos;altra violazione</numerusform>
            <numerusform>altre {count} violazioni</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} more waypoints, the first: {what}</source>
        <translation>
            <numerusform>un altro punto: {what}</numerusform>
            <numerusform>altri {count} punti, il primo: {what}</numerusform>
        </translation>
    </message>
    <message>
        <source>{length:.0f} of the file&apos;s beads are outside the limits of process {process} (width {widthMin:.3g} to {widthMax:.3g}, height {heightMin:.3g} to {heightMax:.3g}): the worst is {width:.2f} wide and {height:.2f} high</source>
        <translation>{length:.0f} dei cordoni del file sono fuori dai limiti del processo {process} (larghezza da {widthMin:.3g} a {widthMax:.3g}, altezza da {heightMin:.3g} a {heightMax:.3g}): il peggiore è largo {width:.2f} e alto {height:.2f}</translation>
    </message>
    <message numerus="yes">
        <source>{what}; {more} more voxels depend on this</source>
        <translation>
            <numerusform>{what}; un altro voxel ne dipende</numerusform>
            <numerusform>{what}; altri {more} voxel ne dipendono</numerusform>
        </translation>
    </message>
    <message>
        <source>turn the part or add supports</source>
        <translation>gira il pezzo o aggiungi i supporti</translation>
    </message>
    <message>
        <source>another column</source>
        <translation>un&apos;altra colonna</translation>
    </message>
    <message>
        <source>argument {key} is not a valid number</source>
        <translation>l&apos;argomento {key} non è un numero valido</translation>
    </message>
    <message>
        <source>around</source>
        <translation>attorno all&apos;asse</translation>
    </message>
    <message>
        <source>at {point:.1f}</source>
        <translation>a {point:.1f}</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automatico</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>asse</translation>
    </message>
    <message>
        <source>part axis</source>
        <translation>asse del pezzo</translation>
    </message>
    <message>
        <source>bead width</source>
        <translation>larghezza cordone</translation>
    </message>
    <message>
        <source>beam</source>
        <translation>a fascio</translation>
    </message>
    <message>
        <source>block &apos;{name}&apos; of the job file is damaged</source>
        <translation>il blocco &apos;{name}&apos; del progetto è danneggiato</translation>
    </message>
    <message>
        <source>break it off after printing</source>
        <translation>staccala dopo la stampa</translation>
    </message>
    <message>
        <source>broken precondition: {what}</source>
        <translation>condizione violata: {what}</translation>
    </message>
    <message>
        <source>byte {code}</source>
        <translation>byte {code}</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>non si può leggere fino alla fine</translation>
    </message>
    <message>
        <source>cannot be read: {why}</source>
        <translation>non si può leggere: {why}</translation>
    </message>
    <message>
        <source>cannot be written: {why}</source>
        <translation>non si può scrivere: {why}</translation>
    </message>
    <message>
        <source>cell {cell}</source>
        <translation>cella {cell}</translation>
    </message>
    <message>
        <source>cell {cell} has a rod, but mode {mode} prints on a plate</source>
        <translation>la cella {cell} ha una barra, ma la modalità {mode} stampa su una piastra</translation>
    </message>
    <message>
        <source>cell {id} has no rod to print on</source>
        <translation>la cella {id} non ha una barra su cui stampare</translation>
    </message>
    <message>
        <source>layer centre</source>
        <translation>centro degli strati</translation>
    </message>
    <message>
        <source>check the flow and the infill density</source>
        <translation>controlla il flusso e la densità del riempimento</translation>
    </message>
    <message>
        <source>checking layers</source>
        <translation>controllo degli strati</translation>
    </message>
    <message>
        <source>checking the motion</source>
        <translation>controllo del movimento</translation>
    </message>
    <message>
        <source>choose a smaller `voxelMm` or `beadWidthMm`</source>
        <translation>scegli un `voxelMm` o un `beadWidthMm` più piccolo</translation>
    </message>
    <message>
        <source>choose layers that reach all of it (`layerShape`, `layerCentre`, `endSurface`)</source>
        <translation>scegliere strati che lo raggiungano tutto (`layerShape`, `layerCentre`, `endSurface`)</translation>
    </message>
    <message>
        <source>choose {least} to {most} pixels per side</source>
        <translation>scegli da {least} a {most} pixel per lato</translation>
    </message>
    <message>
        <source>arm clearance</source>
        <translation>distanza del braccio</translation>
    </message>
    <message>
        <source>clearance to the part</source>
        <translation>distanza dal pezzo</translation>
    </message>
    <message numerus="yes">
        <source>closed {count} holes, the largest of {edges} edges at {at:.2f}</source>
        <translation>
            <numerusform>chiuso {count} foro, di {edges} spigoli a {at:.2f}</numerusform>
            <numerusform>chiusi {count} fori, il più grande di {edges} spigoli a {at:.2f}</numerusform>
        </translation>
    </message>
    <message>
        <source>collisions</source>
        <translation>collisioni</translation>
    </message>
    <message>
        <source>comparing with the plan</source>
        <translation>confronto con il piano</translation>
    </message>
    <message>
        <source>concentric</source>
        <translation>concentrico</translation>
    </message>
    <message>
        <source>contact area + {sizes} mm</source>
        <translation>area di contatto + {sizes} mm</translation>
    </message>
    <message numerus="yes">
        <source>cut it off after printing: it touches the part at {faces} more faces</source>
        <translation>
            <numerusform>tagliala dopo la stampa: tocca il pezzo su un&apos;altra faccia</numerusform>
            <numerusform>tagliala dopo la stampa: tocca il pezzo su altre {faces} facce</numerusform>
        </translation>
    </message>
    <message>
        <source>truncated</source>
        <translation>troncato</translation>
    </message>
    <message>
        <source>truncated within a facet</source>
        <translation>troncato dentro una faccetta</translation>
    </message>
    <message>
        <source>truncated, or not a mesh: {what}</source>
        <translation>troncato, o non è una mesh: {what}</translation>
    </message>
    <message>
        <source>truncated: {bytes} bytes are too few for an STL file</source>
        <translation>troncato: {bytes} byte sono troppo pochi per un file STL</translation>
    </message>
    <message>
        <source>truncated: {there} of {wanted} faces</source>
        <translation>troncato: {there} di {wanted} facce</translation>
    </message>
    <message>
        <source>truncated: {there} of {wanted} vertices</source>
        <translation>troncato: {there} di {wanted} vertici</translation>
    </message>
    <message>
        <source>cut {number}</source>
        <translation>taglio {number}</translation>
    </message>
    <message>
        <source>cutting</source>
        <translation>taglio</translation>
    </message>
    <message>
        <source>cutting layers</source>
        <translation>taglio degli strati</translation>
    </message>
    <message>
        <source>cutting layers from the field</source>
        <translation>taglio degli strati dal campo</translation>
    </message>
    <message>
        <source>cutting planes</source>
        <translation>piani di taglio</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>cilindro</translation>
    </message>
    <message>
        <source>damaged STL: {what}</source>
        <translation>STL danneggiato: {what}</translation>
    </message>
    <message>
        <source>data of the type {type} is not known to the reader</source>
        <translation>dati di tipo {type} non sono noti al lettore</translation>
    </message>
    <message>
        <source>did you mean &apos;{name}&apos;?</source>
        <translation>forse &apos;{name}&apos;?</translation>
    </message>
    <message>
        <source>did you mean {name}?</source>
        <translation>forse {name}?</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>direzioni</translation>
    </message>
    <message>
        <source>disc, {sizes} mm</source>
        <translation>disco, {sizes} mm</translation>
    </message>
    <message>
        <source>is {height} by default, more than the default of beadWidthMm, {width}: beads are no higher than wide</source>
        <translation>di norma è {height}, più del valore normale di beadWidthMm, {width}: un cordone non è più alto che largo</translation>
    </message>
    <message>
        <source>is {tolerance}, not less than the maximum of layerHeightMm, {height}: the head would pass through a layer</source>
        <translation>è {tolerance}, non meno del massimo di layerHeightMm, {height}: la testa attraverserebbe uno strato</translation>
    </message>
    <message>
        <source>is {most:.3g} mm3/s, less than the smallest bead needs at speedMmPerS, {flow:.3g} mm3/s</source>
        <translation>è {most:.3g} mm3/s, meno di quanto serve al cordone più piccolo a speedMmPerS, {flow:.3g} mm3/s</translation>
    </message>
    <message>
        <source>does not rise from z = 0</source>
        <translation>non sale da z = 0</translation>
    </message>
    <message>
        <source>drop it to the plate</source>
        <translation>appoggialo sulla piastra</translation>
    </message>
    <message>
        <source>drop it to the plate, or choose a platform below it</source>
        <translation>appoggialo sulla piastra o scegli una piattaforma sotto di esso</translation>
    </message>
    <message>
        <source>move the part down to the plate</source>
        <translation>appoggia il pezzo sulla piastra</translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} duplicate triangles</source>
        <translation>
            <numerusform>tolto {count} triangolo doppio</numerusform>
            <numerusform>tolti {count} triangoli doppi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} triangles of sheets without volume</source>
        <translation>
            <numerusform>tolto {count} triangolo di lembi senza volume</numerusform>
            <numerusform>tolti {count} triangoli di lembi senza volume</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} triangles without area</source>
        <translation>
            <numerusform>tolto {count} triangolo senza area</numerusform>
            <numerusform>tolti {count} triangoli senza area</numerusform>
        </translation>
    </message>
    <message>
        <source>eax_a is missing: an external axis moves the work object</source>
        <translation>manca eax_a: un asse esterno muove l&apos;oggetto di lavoro</translation>
    </message>
    <message>
        <source>end surface</source>
        <translation>superficie finale</translation>
    </message>
    <message>
        <source>`endSurface` &apos;{text}&apos; is not an end surface</source>
        <translation>`endSurface` &apos;{text}&apos; non è una superficie finale</translation>
    </message>
    <message>
        <source>`endSurface` mesh:FILE requires a platform that is a body</source>
        <translation>`endSurface` mesh:FILE richiede una piattaforma che sia un corpo</translation>
    </message>
    <message>
        <source>ending layers on the surface</source>
        <translation>strati terminati sulla superficie</translation>
    </message>
    <message>
        <source>export or copy the file again</source>
        <translation>esporta o copia di nuovo il file</translation>
    </message>
    <message>
        <source>the extruded volume decreases</source>
        <translation>il volume estruso diminuisce</translation>
    </message>
    <message>
        <source>fewest missed voxels</source>
        <translation>meno voxel mancanti</translation>
    </message>
    <message>
        <source>field</source>
        <translation>campo</translation>
    </message>
    <message>
        <source>file {file}, line {line}</source>
        <translation>file {file}, riga {line}</translation>
    </message>
    <message>
        <source>file {file}, line {line}: {what}</source>
        <translation>file {file}, riga {line}: {what}</translation>
    </message>
    <message>
        <source>fill the hollow first, or use `layerShape=offset`</source>
        <translation>riempi prima la cavità, o usa `layerShape=offset`</translation>
    </message>
    <message>
        <source>first layer</source>
        <translation>primo strato</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>piatto</translation>
    </message>
    <message>
        <source>flatten</source>
        <translation>spiana</translation>
    </message>
    <message>
        <source>flattening</source>
        <translation>spianatura</translation>
    </message>
    <message>
        <source>front</source>
        <translation>fronte</translation>
    </message>
    <message>
        <source>give `--cell lathe`</source>
        <translation>usa `--cell lathe`</translation>
    </message>
    <message>
        <source>give `--mode {modes}`, or another cell</source>
        <translation>usa `--mode {modes}`, o un&apos;altra cella</translation>
    </message>
    <message>
        <source>give `--platform {platforms}`</source>
        <translation>usa `--platform {platforms}`</translation>
    </message>
    <message>
        <source>give `--platform {platforms}`, or `endSurface` flat:Z</source>
        <translation>usa `--platform {platforms}`, o `endSurface` flat:Z</translation>
    </message>
    <message>
        <source>give 0, or {least#} to {most}</source>
        <translation>dai 0, o da {least#} a {most}</translation>
    </message>
    <message>
        <source>choose a higher end surface (`endSurface`)</source>
        <translation>scegli una superficie finale più alta (`endSurface`)</translation>
    </message>
    <message>
        <source>give a list of {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]} or {&quot;corners&quot;: [four points]}, in mm</source>
        <translation>dai una lista di {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]} o {&quot;corners&quot;: [quattro punti]}, in mm</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>dai un numero</translation>
    </message>
    <message>
        <source>give a number from 0.0001 to 10000, or fit</source>
        <translation>dai un numero da 0.0001 a 10000, o fit</translation>
    </message>
    <message>
        <source>give all slices the same number of rows</source>
        <translation>dai a tutte le sezioni lo stesso numero di righe</translation>
    </message>
    <message>
        <source>give an STL, OBJ, PLY, OFF or 3MF file</source>
        <translation>dai un file STL, OBJ, PLY, OFF o 3MF</translation>
    </message>
    <message>
        <source>choose an end surface over the part&apos;s foot</source>
        <translation>scegli una superficie finale sopra il piede del pezzo</translation>
    </message>
    <message>
        <source>choose an end surface of more similar shape, or a narrower part</source>
        <translation>scegli una superficie finale di forma più simile, o un pezzo più stretto</translation>
    </message>
    <message>
        <source>choose an end surface of more similar shape, or a smaller part</source>
        <translation>scegli una superficie finale di forma più simile, o un pezzo più piccolo</translation>
    </message>
    <message>
        <source>give `endSurface=flat:Z` or mesh:FILE</source>
        <translation>usa `endSurface=flat:Z` o mesh:FILE</translation>
    </message>
    <message>
        <source>give `orient=none`</source>
        <translation>usa `orient=none`</translation>
    </message>
    <message>
        <source>use other cutting planes (`cutPlanes`), turn the part, or use curved mode</source>
        <translation>indica altri tagli (`cutPlanes`), gira il pezzo, o usa strati curvi</translation>
    </message>
    <message>
        <source>give pairs of x and radius in mm, x ascending</source>
        <translation>dai coppie di x e raggio in mm, x crescente</translation>
    </message>
    <message>
        <source>give planes: {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]}</source>
        <translation>dai piani: {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]}</translation>
    </message>
    <message>
        <source>verify it against the job it was written from</source>
        <translation>verificalo con il lavoro da cui è stato scritto</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>dai true o false</translation>
    </message>
    <message>
        <source>give {field} from {least#} to {most}</source>
        <translation>dai {field} da {least#} a {most}</translation>
    </message>
    <message>
        <source>give {forms}</source>
        <translation>usa {forms}</translation>
    </message>
    <message>
        <source>give {key}=NUMBER, 0 or more</source>
        <translation>dai {key}=NUMERO, 0 o più</translation>
    </message>
    <message>
        <source>give {least#} to {most}</source>
        <translation>dai da {least#} a {most}</translation>
    </message>
    <message>
        <source>give {least} to {most}</source>
        <translation>dai da {least} a {most}</translation>
    </message>
    <message>
        <source>give {least} to {most} {unit}</source>
        <translation>dai da {least} a {most} {unit}</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>greedy</translation>
    </message>
    <message>
        <source>growth</source>
        <translation>crescita</translation>
    </message>
    <message>
        <source>must have minDeg below maxDeg</source>
        <translation>deve avere minDeg inferiore a maxDeg</translation>
    </message>
    <message>
        <source>must not have zero length</source>
        <translation>non deve avere lunghezza zero</translation>
    </message>
    <message>
        <source>head</source>
        <translation>testina</translation>
    </message>
    <message>
        <source>helical</source>
        <translation>elicoidale</translation>
    </message>
    <message>
        <source>holder</source>
        <translation>portaugello</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pollici</translation>
    </message>
    <message>
        <source>inches are not understood</source>
        <translation>i pollici non sono compresi</translation>
    </message>
    <message>
        <source>infill</source>
        <translation>riempimento</translation>
    </message>
    <message>
        <source>infill &apos;{infill}&apos; needs an axis to wind around, but layer {layer} has none</source>
        <translation>il riempimento &apos;{infill}&apos; si avvolge attorno a un asse, ma lo strato {layer} non ne ha</translation>
    </message>
    <message>
        <source>infill density</source>
        <translation>densità riempimento</translation>
    </message>
    <message>
        <source>infill direction</source>
        <translation>direzione del riempimento</translation>
    </message>
    <message>
        <source>install Mesa (libegl1, libgl1-mesa-dri)</source>
        <translation>installa Mesa (libegl1, libgl1-mesa-dri)</translation>
    </message>
    <message>
        <source>is &apos;{id}&apos;, but the file is named &apos;{file}&apos;</source>
        <translation>è &apos;{id}&apos;, ma il file si chiama &apos;{file}&apos;</translation>
    </message>
    <message>
        <source>is a directory, not a file</source>
        <translation>è una cartella, non un file</translation>
    </message>
    <message>
        <source>is truncated</source>
        <translation>è troncato</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>è danneggiato</translation>
    </message>
    <message>
        <source>is encrypted</source>
        <translation>è cifrato</translation>
    </message>
    <message>
        <source>is larger than 1 GB</source>
        <translation>è più grande di 1 GB</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>manca</translation>
    </message>
    <message>
        <source>is outside the joint&apos;s limits</source>
        <translation>è oltre i limiti del giunto</translation>
    </message>
    <message>
        <source>is compressed with an unsupported method</source>
        <translation>è compresso con un metodo non supportato</translation>
    </message>
    <message>
        <source>is already used: &apos;{name}&apos;</source>
        <translation>è già usato: &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>it is a file, not a folder</source>
        <translation>è un file, non una cartella</translation>
    </message>
    <message>
        <source>two blends overlap, {blend:.3f} in all on a motion of {way:.3f}: the controller skips the waypoint</source>
        <translation>due raccordi si sovrappongono, {blend:.3f} in tutto su un movimento di {way:.3f}: il controllore salta il punto</translation>
    </message>
    <message>
        <source>joint {number}</source>
        <translation>giunto {number}</translation>
    </message>
    <message>
        <source>place the part on a larger face, or use other cutting planes (`cutPlanes`)</source>
        <translation>appoggia il pezzo su una faccia più grande, o indica altri tagli (`cutPlanes`)</translation>
    </message>
    <message>
        <source>layer height</source>
        <translation>altezza strato</translation>
    </message>
    <message>
        <source>layer {layer}, x {x:.1f} y {y:.1f} z {z:.1f}</source>
        <translation>strato {layer}, x {x:.1f} y {y:.1f} z {z:.1f}</translation>
    </message>
    <message>
        <source>`layerCentre` &apos;{text}&apos; is not a point</source>
        <translation>`layerCentre` &apos;{text}&apos; non è un punto</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>strati</translation>
    </message>
    <message>
        <source>layers are 1 to {count}</source>
        <translation>gli strati vanno da 1 a {count}</translation>
    </message>
    <message>
        <source>layers around the rod</source>
        <translation>strati intorno alla barra</translation>
    </message>
    <message>
        <source>layers on this surface would fold from layer {layer} on: its normals cross before the end surface</source>
        <translation>gli strati su questa superficie si piegherebbero dallo strato {layer} in poi: le sue normali si incrociano prima della superficie finale</translation>
    </message>
    <message>
        <source>depositing beads</source>
        <translation>disposizione dei cordoni</translation>
    </message>
    <message>
        <source>minimum overhang</source>
        <translation>meno area a sbalzo</translation>
    </message>
    <message>
        <source>least overhang of pieces</source>
        <translation>minor sbalzo delle parti</translation>
    </message>
    <message>
        <source>least residual area</source>
        <translation>minore area residua</translation>
    </message>
    <message>
        <source>leaves a piece without a base</source>
        <translation>lascia una parte senza base</translation>
    </message>
    <message>
        <source>leaves a piece only {thickness:.2g} thick, thinner than a bead ({least})</source>
        <translation>lascia una parte spessa solo {thickness:.2g}, più sottile di un cordone ({least})</translation>
    </message>
    <message>
        <source>omitted: {what}</source>
        <translation>tralasciato: {what}</translation>
    </message>
    <message>
        <source>left to the controller</source>
        <translation>lasciate al controllore</translation>
    </message>
    <message>
        <source>lengths taken as mm: unknown unit &apos;{unit}&apos;</source>
        <translation>lunghezze prese come mm: unità &apos;{unit}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>lengths converted from {unit} to mm</source>
        <translation>lunghezze convertite da {unit} in mm</translation>
    </message>
    <message>
        <source>reduce the flow, or space the beads further apart</source>
        <translation>riduci il flusso, o distanzia di più i cordoni</translation>
    </message>
    <message>
        <source>give the part a gentler slope from the rod there</source>
        <translation>dai al pezzo una pendenza minore dalla barra in quel punto</translation>
    </message>
    <message>
        <source>give the part a gentler slope from the surface there</source>
        <translation>dai al pezzo una pendenza minore dalla superficie in quel punto</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>sollevamento</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>limite</translation>
    </message>
    <message>
        <source>line {line}</source>
        <translation>riga {line}</translation>
    </message>
    <message>
        <source>line {line}: {what}</source>
        <translation>riga {line}: {what}</translation>
    </message>
    <message>
        <source>load</source>
        <translation>caricamento</translation>
    </message>
    <message>
        <source>longest side {longest:.4g}: the file may be in {unit} (scale {scale})</source>
        <translation>lato più lungo {longest:.4g}: forse il file è in {unit} (scala {scale})</translation>
    </message>
    <message>
        <source>checking support below the beads</source>
        <translation>controllo del sostegno sotto i cordoni</translation>
    </message>
    <message>
        <source>checking for collisions</source>
        <translation>ricerca di collisioni</translation>
    </message>
    <message>
        <source>saved by a newer version of Voluta (format {format}; this version reads up to {newest})</source>
        <translation>salvato da una versione più nuova di Voluta (formato {format}; questa legge fino a {newest})</translation>
    </message>
    <message>
        <source>make all rows equally long</source>
        <translation>fai tutte le righe della stessa lunghezza</translation>
    </message>
    <message>
        <source>make the feature narrower</source>
        <translation>fai il rilievo più stretto</translation>
    </message>
    <message>
        <source>make the object from fewer and larger cells</source>
        <translation>fai l&apos;oggetto di celle meno numerose e più grandi</translation>
    </message>
    <message>
        <source>make the part narrower, or use `layerShape=offset`</source>
        <translation>fai il pezzo più stretto, o usa `layerShape=offset`</translation>
    </message>
    <message>
        <source>piece materials</source>
        <translation>materiali dei pezzi</translation>
    </message>
    <message>
        <source>measuring the beads</source>
        <translation>misura dei cordoni</translation>
    </message>
    <message>
        <source>repair it in a modelling program</source>
        <translation>correggila in un programma di modellazione</translation>
    </message>
    <message>
        <source>repair the mesh in a modelling program if the result looks wrong</source>
        <translation>ripara la mesh in un programma di modellazione se il risultato sembra sbagliato</translation>
    </message>
    <message numerus="yes">
        <source>merged {count} duplicate points</source>
        <translation>
            <numerusform>unito {count} punto doppio</numerusform>
            <numerusform>uniti {count} punti doppi</numerusform>
        </translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metri</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>micrometri</translation>
    </message>
    <message>
        <source>missed voxels</source>
        <translation>voxel mancanti</translation>
    </message>
    <message>
        <source>mode {mode} does not print on platform {platform}</source>
        <translation>la modalità {mode} non stampa sulla piattaforma {platform}</translation>
    </message>
    <message>
        <source>mode {mode} prints around a rod, but cell {cell} has none</source>
        <translation>la modalità {mode} stampa attorno a una barra, ma la cella {cell} non ne ha</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>movimento</translation>
    </message>
    <message>
        <source>move it so that it crosses the part</source>
        <translation>spostalo in modo che attraversi il pezzo</translation>
    </message>
    <message>
        <source>move or tilt the plane slightly</source>
        <translation>sposta o inclina un poco il piano</translation>
    </message>
    <message>
        <source>move the part along the rod, or use a longer rod</source>
        <translation>sposta il pezzo lungo la barra, o usa una barra più lunga</translation>
    </message>
    <message>
        <source>move the part on the rod, or extend it down to the rod there</source>
        <translation>sposta il pezzo sulla barra, o prolungalo lì fino alla barra</translation>
    </message>
    <message>
        <source>move the part on the surface, or extend it down to the surface there</source>
        <translation>sposta il pezzo sulla superficie, o prolungalo lì fino alla superficie</translation>
    </message>
    <message>
        <source>move the part onto the rod</source>
        <translation>sposta il pezzo sulla barra</translation>
    </message>
    <message>
        <source>move the part onto the surface</source>
        <translation>sposta il pezzo sulla superficie</translation>
    </message>
    <message>
        <source>move the part out of the surface, or print it larger</source>
        <translation>sposta il pezzo fuori dalla superficie, o stampalo più grande</translation>
    </message>
    <message>
        <source>move the plane or remove it</source>
        <translation>sposta il piano o eliminalo</translation>
    </message>
    <message>
        <source>move the plane, or point its normal to the side to cut off</source>
        <translation>sposta il piano, o rivolgi la sua normale verso il lato da tagliare</translation>
    </message>
    <message>
        <source>move the planes, or add planes between them</source>
        <translation>sposta i piani, o aggiungine in mezzo</translation>
    </message>
    <message>
        <source>move or remove them</source>
        <translation>spostali, o toglili</translation>
    </message>
    <message>
        <source>must be a capsule, a box or a frustum</source>
        <translation>deve essere una capsula, un parallelepipedo o un tronco di cono</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>deve essere un numero finito</translation>
    </message>
    <message>
        <source>must be a list</source>
        <translation>deve essere una lista</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>deve essere un numero</translation>
    </message>
    <message>
        <source>must be a pair of height and radius</source>
        <translation>deve essere una coppia di altezza e raggio</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>deve essere un testo</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>deve essere un numero intero</translation>
    </message>
    <message>
        <source>must be an object</source>
        <translation>deve essere un oggetto</translation>
    </message>
    <message>
        <source>must be greater than 0</source>
        <translation>deve essere maggiore di 0</translation>
    </message>
    <message>
        <source>must be in 0..{dof}</source>
        <translation>deve essere in 0..{dof}</translation>
    </message>
    <message>
        <source>must be greater than the rod&apos;s radius</source>
        <translation>deve essere maggiore del raggio della barra</translation>
    </message>
    <message>
        <source>must be unwinds or runsOn, is &apos;{end}&apos;</source>
        <translation>deve essere unwinds o runsOn, è &apos;{end}&apos;</translation>
    </message>
    <message>
        <source>must be world or flange, is &apos;{mount}&apos;</source>
        <translation>deve essere world o flange, è &apos;{mount}&apos;</translation>
    </message>
    <message>
        <source>must be world: a rod is held at both ends</source>
        <translation>deve essere world: una barra è tenuta a entrambe le estremità</translation>
    </message>
    <message>
        <source>must include the home position 0 in its limits</source>
        <translation>deve includere la posizione di riposo 0 nei suoi limiti</translation>
    </message>
    <message>
        <source>must have three numbers</source>
        <translation>deve avere tre numeri</translation>
    </message>
    <message>
        <source>must have two names</source>
        <translation>deve avere due nomi</translation>
    </message>
    <message>
        <source>must have at least two sections</source>
        <translation>deve avere almeno due sezioni</translation>
    </message>
    <message>
        <source>must have 6 joints, has {found}</source>
        <translation>deve contenere 6 giunti, ne contiene {found}</translation>
    </message>
    <message>
        <source>must have at least one shape</source>
        <translation>deve contenere almeno una forma</translation>
    </message>
    <message>
        <source>must have exactly one axis, which turns the rod</source>
        <translation>deve contenere un solo asse, che gira la barra</translation>
    </message>
    <message>
        <source>must have {wanted} joints, has {found}</source>
        <translation>deve contenere {wanted} giunti, ne contiene {found}</translation>
    </message>
    <message>
        <source>must not be 0</source>
        <translation>non deve essere 0</translation>
    </message>
    <message>
        <source>must not be negative</source>
        <translation>non deve essere negativo</translation>
    </message>
    <message>
        <source>must differ from the nozzle&apos;s: one of them moves, the other is fixed</source>
        <translation>deve essere diverso da quello dell&apos;ugello: uno dei due si muove, l&apos;altro è fisso</translation>
    </message>
    <message>
        <source>set its axis (`rodAxis`), or rotate the part onto the rod manually</source>
        <translation>imposta il suo asse (`rodAxis`), o ruota il pezzo sulla barra a mano</translation>
    </message>
    <message>
        <source>names an unknown body: &apos;{name}&apos;; did you mean &apos;{nearest}&apos;?</source>
        <translation>indica un corpo sconosciuto: &apos;{name}&apos;; intendevi &apos;{nearest}&apos;?</translation>
    </message>
    <message>
        <source>names an unknown kinematic family: &apos;{id}&apos;</source>
        <translation>indica una famiglia cinematica sconosciuta: &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>names no model</source>
        <translation>non indica alcun modello</translation>
    </message>
    <message>
        <source>needs radii that are not negative, one of them greater than 0</source>
        <translation>richiede raggi non negativi, uno dei quali maggiore di 0</translation>
    </message>
    <message>
        <source>neither a plane nor a quadrilateral</source>
        <translation>né un piano né un quadrilatero</translation>
    </message>
    <message numerus="yes">
        <source>no support column from the platform reaches {voxels} voxels that would be missed</source>
        <translation>
            <numerusform>nessuna colonna di supporto dalla piattaforma raggiunge {voxels} voxel che mancherebbe</numerusform>
            <numerusform>nessuna colonna di supporto dalla piattaforma raggiunge {voxels} voxel che mancherebbero</numerusform>
        </translation>
    </message>
    <message>
        <source>unknown figure &apos;{key}&apos;</source>
        <translation>misura &apos;{key}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>no function is defined</source>
        <translation>nessuna funzione è definita</translation>
    </message>
    <message>
        <source>no number of layers between the surface and the end surface keeps the layer height within {least} to {most} mm: their distance is {shortest:.3g} to {longest:.3g} mm</source>
        <translation>nessun numero di strati tra la superficie e la superficie finale tiene l&apos;altezza degli strati tra {least} e {most} mm: la loro distanza va da {shortest:.3g} a {longest:.3g} mm</translation>
    </message>
    <message>
        <source>no number of layers between the surface and the end surface keeps the layer height within {least} to {most} mm: {layers} layers would be {thinnest:.3g} to {thickest:.3g} mm high</source>
        <translation>nessun numero di strati tra la superficie e la superficie finale tiene l&apos;altezza degli strati tra {least} e {most} mm: {layers} strati sarebbero alti da {thinnest:.3g} a {thickest:.3g} mm</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>il file non esiste</translation>
    </message>
    <message>
        <source>no tool-paths left</source>
        <translation>nessun percorso rimasto</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>nominale</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <source>not JSON: {why}</source>
        <translation>non è JSON: {why}</translation>
    </message>
    <message>
        <source>not a Voluta job</source>
        <translation>non è un progetto di Voluta</translation>
    </message>
    <message>
        <source>invalid filament diameter</source>
        <translation>diametro del filamento non valido</translation>
    </message>
    <message>
        <source>not a mesh file</source>
        <translation>non è un file di mesh</translation>
    </message>
    <message>
        <source>invalid module attributes</source>
        <translation>attributi di modulo non validi</translation>
    </message>
    <message>
        <source>not a program in any known format</source>
        <translation>non è un programma in un formato noto</translation>
    </message>
    <message>
        <source>not a row of the table</source>
        <translation>non è una riga della tabella</translation>
    </message>
    <message>
        <source>not a zip file, or truncated</source>
        <translation>non è uno zip, o è troncato</translation>
    </message>
    <message>
        <source>not a valid procedure header</source>
        <translation>non è un&apos;intestazione di procedura valida</translation>
    </message>
    <message>
        <source>not the header of a joint table</source>
        <translation>non è l&apos;intestazione di una tabella di giunti</translation>
    </message>
    <message>
        <source>not understood: &apos;{code}&apos;</source>
        <translation>non compreso: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>nothing is left of the mesh after repair</source>
        <translation>non resta nulla della mesh dopo la riparazione</translation>
    </message>
    <message>
        <source>no normal of the surface below the part hits the end surface</source>
        <translation>nessuna normale della superficie sotto il pezzo incontra la superficie finale</translation>
    </message>
    <message>
        <source>nothing is on the platform</source>
        <translation>nulla poggia sulla piattaforma</translation>
    </message>
    <message>
        <source>nozzle</source>
        <translation>ugello</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; is missing</source>
        <translation>manca l&apos;oggetto &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>objects contain each other, or there are too many to read</source>
        <translation>oggetti che si contengono a vicenda, o troppi da leggere</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>distanza</translation>
    </message>
    <message>
        <source>on the plate</source>
        <translation>sul piatto</translation>
    </message>
    <message>
        <source>a stop that ends by itself or is skipped</source>
        <translation>un arresto che finisce da solo o viene saltato</translation>
    </message>
    <message>
        <source>a stop that the operator ends</source>
        <translation>un arresto che finisce l&apos;operatore</translation>
    </message>
    <message>
        <source>only three-dimensional OFF files can be read</source>
        <translation>si possono leggere solo file OFF tridimensionali</translation>
    </message>
    <message>
        <source>open</source>
        <translation>apertura</translation>
    </message>
    <message>
        <source>open it with the version that saved it</source>
        <translation>aprilo con la versione che l&apos;ha salvato</translation>
    </message>
    <message>
        <source>ordering layers</source>
        <translation>ordinamento degli strati</translation>
    </message>
    <message>
        <source>to keep the orientation as given, use `orient=none`</source>
        <translation>per conservare l&apos;orientamento dato, usa `orient=none`</translation>
    </message>
    <message>
        <source>`orient={orient}` is for parts on a plate; mode {mode} places them itself</source>
        <translation>`orient={orient}` vale per pezzi su una piastra; la modalità {mode} li dispone da sé</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>orientamento</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>memoria esaurita</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>fuori portata</translation>
    </message>
    <message>
        <source>overhang angle</source>
        <translation>angolo di sbalzo</translation>
    </message>
    <message>
        <source>pair {number}</source>
        <translation>coppia {number}</translation>
    </message>
    <message>
        <source>pairs a body with itself</source>
        <translation>accoppia un corpo con se stesso</translation>
    </message>
    <message>
        <source>peeling</source>
        <translation>spellatura</translation>
    </message>
    <message>
        <source>pick a point on a piece that touches the plate, or place the part on the face to start from</source>
        <translation>scegli un punto su una parte che tocca la piastra, o appoggia il pezzo sulla faccia da cui cominciare</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>pezzi</translation>
    </message>
    <message>
        <source>some areas are narrower than half a bead and stay empty</source>
        <translation>alcune zone sono più strette di mezzo cordone e restano vuote</translation>
    </message>
    <message>
        <source>placed part</source>
        <translation>pezzo posizionato</translation>
    </message>
    <message>
        <source>plan again with more clearance, or place the part elsewhere</source>
        <translation>pianifica di nuovo con più distanza, o metti il pezzo altrove</translation>
    </message>
    <message>
        <source>plan it without --until</source>
        <translation>pianificalo senza --until</translation>
    </message>
    <message>
        <source>plan the part again</source>
        <translation>pianifica di nuovo il pezzo</translation>
    </message>
    <message>
        <source>plan the part further: voluta-cli plan PART -o DIR</source>
        <translation>pianifica oltre il pezzo: voluta-cli plan PEZZO -o CARTELLA</translation>
    </message>
    <message>
        <source>layer planes</source>
        <translation>piani degli strati</translation>
    </message>
    <message>
        <source>layer planes miss the part: {planes}</source>
        <translation>piani di strati non toccano il pezzo: {planes}</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>piattaforma</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; has no valid size</source>
        <translation>la piattaforma &apos;{platform}&apos; non ha una misura valida</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; is not a plate</source>
        <translation>la piattaforma &apos;{platform}&apos; non è una piastra</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; names no file</source>
        <translation>la piattaforma &apos;{platform}&apos; non indica alcun file</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos;: {field} {size} is out of range</source>
        <translation>piattaforma &apos;{platform}&apos;: {field} {size} è fuori dall&apos;intervallo</translation>
    </message>
    <message>
        <source>point {i} is the third one at x = {x:.6g} mm</source>
        <translation>il punto {i} è il terzo a x = {x:.6g} mm</translation>
    </message>
    <message>
        <source>print the part larger, or with a finer process</source>
        <translation>stampa il pezzo più grande, o con un processo più fine</translation>
    </message>
    <message>
        <source>print the part smaller (scale)</source>
        <translation>stampare il pezzo più piccolo (scale)</translation>
    </message>
    <message>
        <source>printed part</source>
        <translation>pezzo stampato</translation>
    </message>
    <message>
        <source>rod profile</source>
        <translation>profilo della barra</translation>
    </message>
    <message>
        <source>put - only under the part or beside its lowest row</source>
        <translation>metti - solo sotto il pezzo o accanto alla sua riga più bassa</translation>
    </message>
    <message>
        <source>put - directly under the part</source>
        <translation>metti - subito sotto il pezzo</translation>
    </message>
    <message>
        <source>orient it by hand</source>
        <translation>orientalo a mano</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>raggio</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>raggiungibile</translation>
    </message>
    <message>
        <source>relative positions are not understood</source>
        <translation>le posizioni relative non sono comprese</translation>
    </message>
    <message>
        <source>repair</source>
        <translation>riparazione</translation>
    </message>
    <message>
        <source>repair it, or use curved mode, which takes any mesh</source>
        <translation>riparala, o usa la modalità curva, che accetta ogni mesh</translation>
    </message>
    <message>
        <source>repair the part first</source>
        <translation>ripara prima il pezzo</translation>
    </message>
    <message>
        <source>repair: check</source>
        <translation>riparazione: controllo</translation>
    </message>
    <message>
        <source>repair: diagnosis</source>
        <translation>riparazione: diagnosi</translation>
    </message>
    <message>
        <source>repair: holes</source>
        <translation>riparazione: fori</translation>
    </message>
    <message>
        <source>repair: orientation</source>
        <translation>riparazione: orientamento</translation>
    </message>
    <message>
        <source>repair: self-intersections</source>
        <translation>riparazione: autointersezioni</translation>
    </message>
    <message>
        <source>replaying {format}</source>
        <translation>riesecuzione di {format}</translation>
    </message>
    <message>
        <source>replayed</source>
        <translation>verificato</translation>
    </message>
    <message>
        <source>risky area</source>
        <translation>area a rischio</translation>
    </message>
    <message>
        <source>robot motion</source>
        <translation>movimento del robot</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>barra</translation>
    </message>
    <message>
        <source>rod, {sizes} mm</source>
        <translation>barra, {sizes} mm</translation>
    </message>
    <message>
        <source>`rodProfile`: &apos;{text}&apos; is neither a pair x,radius nor a file</source>
        <translation>`rodProfile`: &apos;{text}&apos; non è né una coppia x,raggio né un file</translation>
    </message>
    <message>
        <source>root</source>
        <translation>radice</translation>
    </message>
    <message>
        <source>size of the table of patches</source>
        <translation>dimensione della tabella delle superfici</translation>
    </message>
    <message>
        <source>size of the table of pieces</source>
        <translation>dimensione della tabella delle parti</translation>
    </message>
    <message>
        <source>running the program</source>
        <translation>esecuzione del programma</translation>
    </message>
    <message>
        <source>invalid scale &apos;{scale}&apos;</source>
        <translation>scala &apos;{scale}&apos; non valida</translation>
    </message>
    <message>
        <source>scale fit would scale the platform&apos;s mesh with the part</source>
        <translation>la scala fit scalerebbe la mesh della piattaforma con il pezzo</translation>
    </message>
    <message>
        <source>scale the part down</source>
        <translation>riduci la scala del pezzo</translation>
    </message>
    <message>
        <source>scale the part down (`--scale fit`), turn it, or use a larger robot</source>
        <translation>riduci la scala del pezzo (`--scale fit`), giralo, o usa un robot più grande</translation>
    </message>
    <message>
        <source>scale the part down, or move it along the rod</source>
        <translation>riduci la scala del pezzo, o spostalo lungo la barra</translation>
    </message>
    <message>
        <source>scheme</source>
        <translation>schema</translation>
    </message>
    <message>
        <source>see the findings before this one</source>
        <translation>vedi le segnalazioni prima di questa</translation>
    </message>
    <message>
        <source>see: list formats</source>
        <translation>vedi: list formats</translation>
    </message>
    <message numerus="yes">
        <source>separated non-manifold edges at {count} points</source>
        <translation>
            <numerusform>separati spigoli non manifold in {count} punto</numerusform>
            <numerusform>separati spigoli non manifold in {count} punti</numerusform>
        </translation>
    </message>
    <message>
        <source>set {variable}</source>
        <translation>imposta {variable}</translation>
    </message>
    <message>
        <source>set_tcp needs a pose</source>
        <translation>set_tcp richiede una posa</translation>
    </message>
    <message>
        <source>layer shape</source>
        <translation>forma degli strati</translation>
    </message>
    <message>
        <source>use shorter motions or smaller blends</source>
        <translation>usa movimenti più corti o raccordi più piccoli</translation>
    </message>
    <message>
        <source>rod sides</source>
        <translation>lati della barra</translation>
    </message>
    <message>
        <source>skeleton</source>
        <translation>scheletro</translation>
    </message>
    <message>
        <source>sleep needs a time in seconds</source>
        <translation>sleep richiede un tempo in secondi</translation>
    </message>
    <message>
        <source>slice {slice} ends after {rows} rows, the first one after {first}</source>
        <translation>la sezione {slice} finisce dopo {rows} righe, la prima dopo {first}</translation>
    </message>
    <message>
        <source>slicing</source>
        <translation>taglio in strati</translation>
    </message>
    <message>
        <source>print slower there, or place the part elsewhere in the cell</source>
        <translation>stampa più lentamente lì, o metti il pezzo altrove nella cella</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>sfera</translation>
    </message>
    <message numerus="yes">
        <source>split edges at {count} T-junctions</source>
        <translation>
            <numerusform>divisi spigoli in {count} giunzione a T</numerusform>
            <numerusform>divisi spigoli in {count} giunzioni a T</numerusform>
        </translation>
    </message>
    <message>
        <source>stated</source>
        <translation>dichiarate</translation>
    </message>
    <message>
        <source>step</source>
        <translation>passo</translation>
    </message>
    <message>
        <source>step height</source>
        <translation>altezza del gradino</translation>
    </message>
    <message>
        <source>supports</source>
        <translation>supporti</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>superficie</translation>
    </message>
    <message>
        <source>choose a cell with a rod: `--cell lathe`</source>
        <translation>usa una cella con una barra: `--cell lathe`</translation>
    </message>
    <message>
        <source>choose a shorter rod</source>
        <translation>usa una barra più corta</translation>
    </message>
    <message>
        <source>choose a thinner rod</source>
        <translation>usa una barra più sottile</translation>
    </message>
    <message>
        <source>subtract the rod from the part</source>
        <translation>barra tolta dal pezzo</translation>
    </message>
    <message>
        <source>subtract the surface from the part</source>
        <translation>superficie tolta dal pezzo</translation>
    </message>
    <message>
        <source>use {formats}</source>
        <translation>usa {formats}</translation>
    </message>
    <message>
        <source>text after ENDMODULE</source>
        <translation>testo dopo ENDMODULE</translation>
    </message>
    <message>
        <source>text after the end</source>
        <translation>testo dopo la fine</translation>
    </message>
    <message>
        <source>the arm cannot reach this target</source>
        <translation>il braccio non può raggiungere questa posizione</translation>
    </message>
    <message>
        <source>the arm&apos;s configuration is not the planned one: a joint differs by {angle:.1f}</source>
        <translation>la configurazione del braccio non è quella pianificata: un giunto differisce di {angle:.1f}</translation>
    </message>
    <message>
        <source>the arm would have to change its configuration: {joint} would jump by {angle:.1f}</source>
        <translation>il braccio dovrebbe cambiare configurazione: {joint} salterebbe di {angle:.1f}</translation>
    </message>
    <message>
        <source>configuration supervision is on: ConfL\Off, ConfJ\Off</source>
        <translation>la sorveglianza della configurazione è attiva: ConfL\Off, ConfJ\Off</translation>
    </message>
    <message>
        <source>the end sequence (M104 S0, M84, &apos;; end&apos;) is missing: the file is truncated</source>
        <translation>manca la sequenza finale (M104 S0, M84, &apos;; end&apos;): il file è troncato</translation>
    </message>
    <message>
        <source>the end sequence is missing</source>
        <translation>manca la sequenza finale</translation>
    </message>
    <message>
        <source>the end surface is {rise:.3g} mm above the top of the starting surface</source>
        <translation>la superficie finale è {rise:.3g} mm sopra la cima della superficie di partenza</translation>
    </message>
    <message>
        <source>external axis {angle:.3f} off its planned position</source>
        <translation>asse esterno a {angle:.3f} dalla posizione pianificata</translation>
    </message>
    <message>
        <source>the extruder is not switched off after the last motion</source>
        <translation>l&apos;estrusore non viene spento dopo l&apos;ultimo movimento</translation>
    </message>
    <message>
        <source>the extruder is off during a bead</source>
        <translation>l&apos;estrusore è spento durante un cordone</translation>
    </message>
    <message>
        <source>the extruder is on during a travel</source>
        <translation>l&apos;estrusore è acceso durante uno spostamento</translation>
    </message>
    <message>
        <source>the extruder&apos;s outputs are not set before this motion</source>
        <translation>le uscite dell&apos;estrusore non sono impostate prima di questo movimento</translation>
    </message>
    <message>
        <source>the feature is {width:.3g} mm wide, wider than its cylinder of {cylinder:.3g} mm</source>
        <translation>il rilievo è largo {width:.3g} mm, più del suo cilindro di {cylinder:.3g} mm</translation>
    </message>
    <message>
        <source>the file ends without &quot;endsolid&quot;: it may be truncated</source>
        <translation>il file finisce senza &quot;endsolid&quot;: forse è troncato</translation>
    </message>
    <message>
        <source>the file contains no cells</source>
        <translation>il file non contiene celle</translation>
    </message>
    <message>
        <source>the file is truncated: {what}</source>
        <translation>il file è troncato: {what}</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>il file è vuoto</translation>
    </message>
    <message>
        <source>the file&apos;s top {what}</source>
        <translation>il livello superiore del file {what}</translation>
    </message>
    <message>
        <source>the first module has no procedure main</source>
        <translation>il primo modulo non ha la procedura main</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; has no end</source>
        <translation>la funzione &apos;{defined}&apos; non ha fine</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; is never called</source>
        <translation>la funzione &apos;{defined}&apos; non viene mai chiamata</translation>
    </message>
    <message>
        <source>the function is never called</source>
        <translation>la funzione non viene mai chiamata</translation>
    </message>
    <message>
        <source>the header has no end</source>
        <translation>l&apos;intestazione non ha fine</translation>
    </message>
    <message>
        <source>the header line is missing</source>
        <translation>manca la riga d&apos;intestazione</translation>
    </message>
    <message>
        <source>the header states no format</source>
        <translation>l&apos;intestazione non indica il formato</translation>
    </message>
    <message>
        <source>the header states no facets; {facets} read</source>
        <translation>l&apos;intestazione non indica faccette; lette {facets}</translation>
    </message>
    <message>
        <source>the job file is inconsistent</source>
        <translation>il progetto non è coerente</translation>
    </message>
    <message>
        <source>the job file is inconsistent: {what}</source>
        <translation>il progetto non è coerente: {what}</translation>
    </message>
    <message>
        <source>the job file is truncated</source>
        <translation>il progetto è troncato</translation>
    </message>
    <message>
        <source>the first line of the job file is damaged or truncated</source>
        <translation>la prima riga del progetto è danneggiata o troncata</translation>
    </message>
    <message>
        <source>block &apos;{name}&apos; is missing in the job file</source>
        <translation>nel progetto manca il blocco &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>the job file&apos;s header is damaged</source>
        <translation>l&apos;intestazione del progetto è danneggiata</translation>
    </message>
    <message>
        <source>the job file&apos;s header is damaged: {why}</source>
        <translation>l&apos;intestazione del progetto è danneggiata: {why}</translation>
    </message>
    <message>
        <source>the job has no motion to verify against</source>
        <translation>il progetto non contiene un movimento con cui verificare</translation>
    </message>
    <message>
        <source>the job contains no {result}</source>
        <translation>il progetto non contiene {result}</translation>
    </message>
    <message>
        <source>the letter {letter} has no number</source>
        <translation>la lettera {letter} è senza numero</translation>
    </message>
    <message>
        <source>the line &apos;# end&apos; is missing: the file is truncated</source>
        <translation>manca la riga &apos;# end&apos;: il file è stato troncato</translation>
    </message>
    <message>
        <source>the list of modules has no end</source>
        <translation>la lista dei moduli non ha fine</translation>
    </message>
    <message>
        <source>deposited volume: {share:.2f} of the part&apos;s</source>
        <translation>volume deposto: il {share:.2f} di quello del pezzo</translation>
    </message>
    <message>
        <source>mechanical unit &apos;{text}&apos; is not active: ActUnit</source>
        <translation>l&apos;unità meccanica &apos;{text}&apos; non è attiva: ActUnit</translation>
    </message>
    <message>
        <source>the mesh has no triangles</source>
        <translation>la mesh non ha triangoli</translation>
    </message>
    <message>
        <source>the mesh is empty: no facet has valid coordinates</source>
        <translation>la mesh è vuota: nessuna faccetta ha coordinate valide</translation>
    </message>
    <message>
        <source>the mesh is empty: the file has no triangles</source>
        <translation>la mesh è vuota: il file non contiene triangoli</translation>
    </message>
    <message>
        <source>the mesh is not closed</source>
        <translation>la mesh non è chiusa</translation>
    </message>
    <message>
        <source>the module has no procedure</source>
        <translation>il modulo non ha procedure</translation>
    </message>
    <message>
        <source>the module with {procedure} is missing</source>
        <translation>manca il modulo con {procedure}</translation>
    </message>
    <message>
        <source>module {name} is missing</source>
        <translation>manca il modulo {name}</translation>
    </message>
    <message>
        <source>the normal has zero length</source>
        <translation>la normale ha lunghezza zero</translation>
    </message>
    <message>
        <source>nozzle {distance:.3f} off the planned path</source>
        <translation>ugello a {distance:.3f} dal percorso pianificato</translation>
    </message>
    <message>
        <source>nozzle axis {angle:.2f} off the planned direction</source>
        <translation>asse dell&apos;ugello a {angle:.2f} dalla direzione pianificata</translation>
    </message>
    <message>
        <source>the numbers of vertices and faces are expected here</source>
        <translation>qui sono attesi i numeri di vertici e facce</translation>
    </message>
    <message>
        <source>no part: no 1 above the platform</source>
        <translation>nessun pezzo: nessun 1 sopra la piattaforma</translation>
    </message>
    <message>
        <source>the object is too large</source>
        <translation>l&apos;oggetto è troppo grande</translation>
    </message>
    <message>
        <source>the part below</source>
        <translation>il pezzo sottostante</translation>
    </message>
    <message>
        <source>the part does not touch the plate</source>
        <translation>il pezzo non tocca la piastra</translation>
    </message>
    <message>
        <source>the part does not touch the platform</source>
        <translation>il pezzo non tocca la piattaforma</translation>
    </message>
    <message>
        <source>the part has no clear axis: its surface normals have no preferred direction</source>
        <translation>il pezzo non ha un asse chiaro: le normali della sua superficie non hanno una direzione preferita</translation>
    </message>
    <message>
        <source>the part has no surface</source>
        <translation>il pezzo non ha superficie</translation>
    </message>
    <message>
        <source>the part is not closed or self-intersects where the rod is subtracted</source>
        <translation>il pezzo non è chiuso o si autointerseca dove viene sottratta la barra</translation>
    </message>
    <message>
        <source>the part is not closed or self-intersects where the surface&apos;s body is subtracted</source>
        <translation>il pezzo non è chiuso o si autointerseca dove viene sottratto il corpo della superficie</translation>
    </message>
    <message>
        <source>the part is too large for a collision grid of this resolution</source>
        <translation>il pezzo è troppo grande per una griglia di collisioni di questa risoluzione</translation>
    </message>
    <message numerus="yes">
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): {missed} missed voxels ({voxel:.2f} wide) instead of {missedBefore}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>
            <numerusform>il pezzo è stato girato di {angle:.0f} attorno a ({x}, {y}, {z}): {missed} voxel mancato (largo {voxel:.2f}) invece di {missedBefore}, sbalzo {overhang:.0f} invece di {overhangBefore:.0f#}</numerusform>
            <numerusform>il pezzo è stato girato di {angle:.0f} attorno a ({x}, {y}, {z}): {missed} voxel mancati (larghi {voxel:.2f}) invece di {missedBefore}, sbalzo {overhang:.0f} invece di {overhangBefore:.0f#}</numerusform>
        </translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): estimated overhang after cutting {left:.0f} (pieces: {pieces}) instead of {leftBefore:.0f#} (pieces: {piecesBefore}); uncut {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>il pezzo è stato girato di {angle:.0f} attorno a ({x}, {y}, {z}): sbalzo stimato dopo i tagli {left:.0f} (parti: {pieces}) invece di {leftBefore:.0f#} (parti: {piecesBefore}); senza tagli {overhang:.0f} invece di {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>il pezzo è stato girato di {angle:.0f} attorno a ({x}, {y}, {z}): sbalzo {overhang:.0f} invece di {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): residual area on XY {xy:.0f} instead of {xyBefore:.0f#}, on XZ {xz:.0f} instead of {xzBefore:.0f#}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>il pezzo è stato girato di {angle:.0f} attorno a ({x}, {y}, {z}): area residua su XY {xy:.0f} invece di {xyBefore:.0f#}, su XZ {xz:.0f} invece di {xzBefore:.0f#}, sbalzo {overhang:.0f} invece di {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part is {width:.3g} mm wide, at least as wide as the cylinder below it</source>
        <translation>il pezzo è largo {width:.3g} mm, almeno quanto il cilindro su cui poggia</translation>
    </message>
    <message>
        <source>the part misses the rod: no layer of it rests on the rod</source>
        <translation>il pezzo manca la barra: nessun suo strato poggia sulla barra</translation>
    </message>
    <message>
        <source>the part misses the surface: no layer of it rests on the surface</source>
        <translation>il pezzo manca la superficie: nessun suo strato poggia sulla superficie</translation>
    </message>
    <message>
        <source>the part reaches below the platform</source>
        <translation>il pezzo arriva sotto la piattaforma</translation>
    </message>
    <message>
        <source>the part extends from x = {from:.4g} to {to:.4g} mm, beyond an end of the rod at {firstEnd:.4g} or {lastEnd:.4g} mm</source>
        <translation>il pezzo va da x = {from:.4g} a {to:.4g} mm, oltre un&apos;estremità della barra a {firstEnd:.4g} o {lastEnd:.4g} mm</translation>
    </message>
    <message>
        <source>the part extends {height:.3g} mm beyond the rod, less than a layer of {least:.3g} mm</source>
        <translation>il pezzo sporge di {height:.3g} mm dalla barra, meno di uno strato di {least:.3g} mm</translation>
    </message>
    <message>
        <source>the part extends to {reach:.4g} from the rod&apos;s axis; the cell prints up to {limit}</source>
        <translation>il pezzo arriva a {reach:.4g} dall&apos;asse della barra, la cella stampa fino a {limit}</translation>
    </message>
    <message>
        <source>the part rises {height:.3g} mm above the surface, less than a layer of {least:.3g} mm</source>
        <translation>il pezzo sale di {height:.3g} mm sopra la superficie, meno di uno strato di {least:.3g} mm</translation>
    </message>
    <message>
        <source>an end surface radius:R requires a cylinder along x below the part</source>
        <translation>una superficie finale radius:R richiede un cilindro lungo x sotto il pezzo</translation>
    </message>
    <message numerus="yes">
        <source>the part keeps its orientation: none of {ways} stable ones is better</source>
        <translation>
            <numerusform>il pezzo mantiene il suo orientamento: l&apos;unico altro stabile non è migliore</numerusform>
            <numerusform>il pezzo mantiene il suo orientamento: nessuno dei {ways} stabili è migliore</numerusform>
        </translation>
    </message>
    <message>
        <source>the placement is not a rotation and a position in mm</source>
        <translation>il posizionamento non è una rotazione e una posizione in mm</translation>
    </message>
    <message>
        <source>the plane misses the part</source>
        <translation>il piano non tocca il pezzo</translation>
    </message>
    <message>
        <source>the planes are not a JSON list</source>
        <translation>i piani non sono una lista JSON</translation>
    </message>
    <message>
        <source>the platform</source>
        <translation>la piattaforma</translation>
    </message>
    <message>
        <source>the platform&apos;s mesh is not closed</source>
        <translation>la mesh della piattaforma non è chiusa</translation>
    </message>
    <message>
        <source>the points are collinear</source>
        <translation>i punti sono allineati</translation>
    </message>
    <message>
        <source>the print head would cut into printed material, however it is tilted</source>
        <translation>la testa di stampa urterebbe materiale già stampato, comunque si inclini</translation>
    </message>
    <message>
        <source>the procedure has no ENDPROC</source>
        <translation>la procedura non ha ENDPROC</translation>
    </message>
    <message numerus="yes">
        <source>the program ends here; {motions} planned motions are missing</source>
        <translation>
            <numerusform>il programma finisce qui; manca {motions} movimento pianificato</numerusform>
            <numerusform>il programma finisce qui; mancano {motions} movimenti pianificati</numerusform>
        </translation>
    </message>
    <message>
        <source>the program has no motions</source>
        <translation>il programma non ha movimenti</translation>
    </message>
    <message>
        <source>the program runs from 0 to {end:.1f}</source>
        <translation>il programma va da 0 a {end:.1f}</translation>
    </message>
    <message>
        <source>the program&apos;s data folder is missing</source>
        <translation>manca la cartella dei dati del programma</translation>
    </message>
    <message>
        <source>the program&apos;s motions do not match this plan</source>
        <translation>i movimenti del programma non corrispondono a questo piano</translation>
    </message>
    <message>
        <source>the quadrilateral has no area</source>
        <translation>il quadrilatero non ha area</translation>
    </message>
    <message>
        <source>the quadrilateral is not convex</source>
        <translation>il quadrilatero non è convesso</translation>
    </message>
    <message>
        <source>the quadrilateral is not flat</source>
        <translation>il quadrilatero non è piano</translation>
    </message>
    <message>
        <source>the radius at point {i} is not positive</source>
        <translation>il raggio al punto {i} non è positivo</translation>
    </message>
    <message>
        <source>not a plan&apos;s report: {why}</source>
        <translation>non è il rapporto di un piano: {why}</translation>
    </message>
    <message>
        <source>the robot motion is empty</source>
        <translation>il movimento del robot è vuoto</translation>
    </message>
    <message>
        <source>the rod is thicker than the part and contains all of it</source>
        <translation>la barra è più spessa del pezzo e lo contiene tutto</translation>
    </message>
    <message>
        <source>the rod extends {reach} mm from its middle; the cell has room for {room} mm</source>
        <translation>la barra arriva a {reach} mm dal suo centro; la cella ha posto per {room} mm</translation>
    </message>
    <message>
        <source>the rod&apos;s radius is {radius} mm; the cell prints up to {most} mm</source>
        <translation>il raggio della barra è {radius} mm; la cella stampa fino a {most} mm</translation>
    </message>
    <message>
        <source>the root at {x:.1f}, {y:.1f}, {z:.1f} mm is not on the plate</source>
        <translation>la radice a {x:.1f}, {y:.1f}, {z:.1f} mm non è sulla piastra</translation>
    </message>
    <message>
        <source>the row has {cells} cells, the first one {first}</source>
        <translation>la riga ha {cells} celle, la prima ne ha {first}</translation>
    </message>
    <message>
        <source>the body of the surface contains the whole part</source>
        <translation>il corpo della superficie contiene tutto il pezzo</translation>
    </message>
    <message>
        <source>the voxel object is lifted by a fraction of a voxel: it is cut into new voxels</source>
        <translation>l&apos;oggetto di voxel è sollevato di una frazione di voxel: viene diviso in voxel nuovi</translation>
    </message>
    <message>
        <source>the voxel object is not rotated by a multiple of 90°: it is cut into new voxels</source>
        <translation>l&apos;oggetto di voxel non è ruotato di un multiplo di 90°: viene diviso in voxel nuovi</translation>
    </message>
    <message>
        <source>the voxels are too small for a part of this size</source>
        <translation>i voxel sono troppo piccoli per un pezzo di questa misura</translation>
    </message>
    <message>
        <source>the {format} program is not released: {failed}</source>
        <translation>il programma {format} non viene consegnato: {failed}</translation>
    </message>
    <message>
        <source>there is no layer {layer}</source>
        <translation>lo strato {layer} non esiste</translation>
    </message>
    <message>
        <source>no module</source>
        <translation>nessun modulo</translation>
    </message>
    <message>
        <source>there is no platform: no - in any row</source>
        <translation>non c&apos;è piattaforma: nessun - in alcuna riga</translation>
    </message>
    <message>
        <source>there is no time {time}</source>
        <translation>il tempo {time} non esiste</translation>
    </message>
    <message>
        <source>thicken the wall to {least} or more</source>
        <translation>ispessisci la parete a {least} o più</translation>
    </message>
    <message>
        <source>thickness classes</source>
        <translation>classi di spessore</translation>
    </message>
    <message>
        <source>OpenGL 3.2 without a display is not available: {why}</source>
        <translation>OpenGL 3.2 senza schermo non è disponibile: {why}</translation>
    </message>
    <message>
        <source>this is not the module that main runs next</source>
        <translation>questo modulo non è quello che main esegue dopo</translation>
    </message>
    <message>
        <source>this motion and the one at {other} are swapped</source>
        <translation>questo movimento e quello in {other} sono scambiati</translation>
    </message>
    <message>
        <source>this motion deposits {volume:.3f} instead of {planned:.3f}</source>
        <translation>questo movimento depone {volume:.3f} invece di {planned:.3f}</translation>
    </message>
    <message>
        <source>this motion takes {time:.3f} instead of {planned:.3f}</source>
        <translation>questo movimento dura {time:.3f} invece di {planned:.3f}</translation>
    </message>
    <message>
        <source>time decreases</source>
        <translation>il tempo diminuisce</translation>
    </message>
    <message>
        <source>too many triangles for an STL file</source>
        <translation>troppi triangoli per un file STL</translation>
    </message>
    <message>
        <source>tool-paths</source>
        <translation>percorsi utensile</translation>
    </message>
    <message>
        <source>touch points farther apart around the cylinder</source>
        <translation>tocca punti più lontani tra loro attorno al cilindro</translation>
    </message>
    <message>
        <source>touched points</source>
        <translation>punti toccati</translation>
    </message>
    <message>
        <source>trimming layers on the part</source>
        <translation>rifilatura degli strati sul pezzo</translation>
    </message>
    <message>
        <source>try a larger `voxelMm` or a smaller part</source>
        <translation>prova un `voxelMm` più grande o un pezzo più piccolo</translation>
    </message>
    <message>
        <source>to keep its voxels, rotate it by multiples of 90° and lift it by whole voxels</source>
        <translation>per conservare i suoi voxel, ruotalo di multipli di 90° e sollevalo di voxel interi</translation>
    </message>
    <message>
        <source>infill rotation per layer</source>
        <translation>rotazione del riempimento per strato</translation>
    </message>
    <message>
        <source>turn the part (`orient=leastRisky`), add supports, or use planar or curved mode</source>
        <translation>gira il pezzo (`orient=leastRisky`), aggiungi supporti, o usa pezzi piani o strati curvi</translation>
    </message>
    <message>
        <source>turn the part (`orient=leastRisky`), or use planar or curved mode</source>
        <translation>gira il pezzo (`orient=leastRisky`), o usa pezzi piani o strati curvi</translation>
    </message>
    <message>
        <source>turn the part about the vertical, or try more rotations (`redundancySamples`)</source>
        <translation>gira il pezzo attorno alla verticale, o prova più rotazioni (`redundancySamples`)</translation>
    </message>
    <message>
        <source>turn the part, enlarge the platform or add supports</source>
        <translation>gira il pezzo, allarga la piattaforma o aggiungi supporti</translation>
    </message>
    <message>
        <source>turn the part, make the platform smaller or add supports</source>
        <translation>gira il pezzo, rimpicciolisci la piattaforma o aggiungi supporti</translation>
    </message>
    <message>
        <source>turn the part, or allow less clearance</source>
        <translation>gira il pezzo, o ammetti meno distanza</translation>
    </message>
    <message>
        <source>turn the part, use a smaller platform, or allow less clearance</source>
        <translation>gira il pezzo, usa una piattaforma più piccola, o ammetti meno distanza</translation>
    </message>
    <message numerus="yes">
        <source>flipped {count} inside-out components</source>
        <translation>
            <numerusform>{count} componente rovesciata corretta</numerusform>
            <numerusform>{count} componenti rovesciate corrette</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>flipped {count} triangles to match their neighbours</source>
        <translation>
            <numerusform>{count} triangolo rovesciato per accordarlo ai vicini</numerusform>
            <numerusform>{count} triangoli rovesciati per accordarli ai vicini</numerusform>
        </translation>
    </message>
    <message>
        <source>turn the part: other orientations may need fewer</source>
        <translation>gira il pezzo: con altri orientamenti forse ne servono meno</translation>
    </message>
    <message>
        <source>rotations tried per point</source>
        <translation>rotazioni provate per punto</translation>
    </message>
    <message>
        <source>two commands in one line</source>
        <translation>due comandi in una riga</translation>
    </message>
    <message numerus="yes">
        <source>merged {count} overlapping components</source>
        <translation>
            <numerusform>unita {count} componente sovrapposta</numerusform>
            <numerusform>unite {count} componenti sovrapposte</numerusform>
        </translation>
    </message>
    <message>
        <source>unknown cell &apos;{id}&apos;</source>
        <translation>cella &apos;{id}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown cell &apos;{name}&apos;</source>
        <translation>cella &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown colour &apos;{name}&apos;</source>
        <translation>colore &apos;{name}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown failure</source>
        <translation>errore sconosciuto</translation>
    </message>
    <message>
        <source>unknown format &apos;{id}&apos;</source>
        <translation>formato &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown format &apos;{name}&apos;</source>
        <translation>formato &apos;{name}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown growth &apos;{name}&apos;</source>
        <translation>crescita &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown infill &apos;{id}&apos;</source>
        <translation>riempimento &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown key &apos;{key}&apos;</source>
        <translation>chiave &apos;{key}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown mode &apos;{name}&apos;</source>
        <translation>modalità &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown parameter &apos;{key}&apos;</source>
        <translation>parametro &apos;{key}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown picture &apos;{name}&apos;</source>
        <translation>immagine &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown platform &apos;{name}&apos;</source>
        <translation>piattaforma &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown process &apos;{id}&apos;</source>
        <translation>processo &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown process &apos;{name}&apos;</source>
        <translation>processo &apos;{name}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown robot &apos;{id}&apos;</source>
        <translation>robot &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown sample &apos;{name}&apos;</source>
        <translation>esempio &apos;{name}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown stage &apos;{name}&apos;</source>
        <translation>fase &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown view &apos;{name}&apos;</source>
        <translation>vista &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>use a finer nozzle, or print the part larger</source>
        <translation>usa un ugello più fine, o stampa il pezzo più grande</translation>
    </message>
    <message>
        <source>use a larger platform (fit:MARGIN), or turn the part</source>
        <translation>usa una piattaforma più grande (fit:MARGIN), o gira il pezzo</translation>
    </message>
    <message>
        <source>use a slimmer print head, turn the part, or print it larger</source>
        <translation>usa una testa più snella, gira il pezzo, o stampalo più grande</translation>
    </message>
    <message>
        <source>use a slimmer print head or thinner layers</source>
        <translation>usa una testina più snella o strati più sottili</translation>
    </message>
    <message>
        <source>use a smaller platform or place the part higher</source>
        <translation>usa una piattaforma più piccola o metti il pezzo più in alto</translation>
    </message>
    <message>
        <source>use a thinner rod, or print the part larger</source>
        <translation>usa una barra più sottile, o stampa il pezzo più grande</translation>
    </message>
    <message>
        <source>use at least {least}</source>
        <translation>usa almeno {least}</translation>
    </message>
    <message>
        <source>use at most {side} cells a side and {millions} million in all</source>
        <translation>usa al massimo {side} celle per lato e {millions} milioni in tutto</translation>
    </message>
    <message>
        <source>use infill zigzag or concentric, or mode lathe</source>
        <translation>usa il riempimento zigzag o concentric, o la modalità lathe</translation>
    </message>
    <message>
        <source>use lower layers or a finer nozzle, or print the part larger</source>
        <translation>usa strati più bassi o un ugello più fine, o stampa il pezzo più grande</translation>
    </message>
    <message>
        <source>voxelise</source>
        <translation>voxelizzazione</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>voxel</translation>
    </message>
    <message>
        <source>voxels of {width} need about {needed} of memory; {available} are free</source>
        <translation>voxel di {width} richiedono circa {needed} di memoria, ne sono liberi {available}</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>pareti</translation>
    </message>
    <message>
        <source>UnLoad of a module that was not loaded and run</source>
        <translation>UnLoad di un modulo che non è stato caricato ed eseguito</translation>
    </message>
    <message>
        <source>winding angle</source>
        <translation>angolo avvolgimento</translation>
    </message>
    <message>
        <source>woven</source>
        <translation>intrecciato</translation>
    </message>
    <message>
        <source>write 1 for the part, 0 for air, - for the platform</source>
        <translation>scrivi 1 per il pezzo, 0 per l&apos;aria, - per la piattaforma</translation>
    </message>
    <message>
        <source>write 1 where the part is</source>
        <translation>scrivi 1 dove sta il pezzo</translation>
    </message>
    <message>
        <source>write files</source>
        <translation>scrittura dei file</translation>
    </message>
    <message>
        <source>write flat, flat:Z, radius:R or mesh:FILE, in mm</source>
        <translation>scrivi flat, flat:Z, radius:R o mesh:FILE, in mm</translation>
    </message>
    <message>
        <source>write pairs such as -20,2.5 0,2.5 0,3.5 20,3.5 in mm</source>
        <translation>scrivi coppie come -20,2.5 0,2.5 0,3.5 20,3.5 in mm</translation>
    </message>
    <message>
        <source>write refused programs</source>
        <translation>scrivi i programmi respinti</translation>
    </message>
    <message>
        <source>write rows of 0 and 1, and - for the platform</source>
        <translation>scrivi righe di 0 e 1, e - per la piattaforma</translation>
    </message>
    <message>
        <source>write the program again; to keep this change, make it in the plan</source>
        <translation>riscrivi il programma; per conservare questa modifica, falla nel piano</translation>
    </message>
    <message>
        <source>write intermediate results</source>
        <translation>scrivi i risultati intermedi</translation>
    </message>
    <message>
        <source>write x,y,z in mm</source>
        <translation>scrivi x,y,z in mm</translation>
    </message>
    <message>
        <source>write x,y,z in mm, such as 10,0,5</source>
        <translation>scrivi x,y,z in mm, come 10,0,5</translation>
    </message>
    <message>
        <source>writing {format}</source>
        <translation>scrittura di {format}</translation>
    </message>
    <message>
        <source>write {form}</source>
        <translation>scrivi {form}</translation>
    </message>
    <message>
        <source>write {form}, in mm</source>
        <translation>scrivi {form}, in mm</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x decreases at point {i}</source>
        <translation>x diminuisce al punto {i}</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>zigzag</source>
        <translation>zigzag</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs by more than {angle}</source>
        <translation>{area:.3g} sporgono di oltre {angle}</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs lower layers by more than {angle:.3g}, most at x = {x:.4g}, radius {radius:.4g}</source>
        <translation>{area:.3g} sporgono di oltre {angle:.3g} sugli strati inferiori, soprattutto a x = {x:.4g}, raggio {radius:.4g}</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs lower layers by more than {angle:.3g}, most at {at:.4g}</source>
        <translation>{area:.3g} sporgono di oltre {angle:.3g} sugli strati inferiori, soprattutto a {at:.4g}</translation>
    </message>
    <message numerus="yes">
        <source>{bad} of {facets} facets have NaN or out-of-range coordinates, first at facet {first}</source>
        <translation>
            <numerusform>{bad} di {facets} faccette ha coordinate NaN o fuori intervallo, la prima è la faccetta {first}</numerusform>
            <numerusform>{bad} di {facets} faccette hanno coordinate NaN o fuori intervallo, la prima è la faccetta {first}</numerusform>
        </translation>
    </message>
    <message>
        <source>blocked pieces: {blocked} of {pieces}; earlier pieces are in the print head&apos;s way</source>
        <translation>parti bloccate: {blocked} di {pieces}; parti già stampate intralciano la testina</translation>
    </message>
    <message numerus="yes">
        <source>{columns} more support columns under voxels that would be missed</source>
        <translation>
            <numerusform>un&apos;altra colonna di supporto sotto voxel che mancherebbero</numerusform>
            <numerusform>altre {columns} colonne di supporto sotto voxel che mancherebbero</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} inside-out components, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} componente rovesciata, a {first:.2f}</numerusform>
            <numerusform>{count} componenti rovesciate, la prima a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} duplicate triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} triangolo doppio, a {first:.2f}</numerusform>
            <numerusform>{count} triangoli doppi, il primo a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} edges with inconsistently oriented triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} spigolo i cui triangoli guardano in versi opposti, a {first:.2f}</numerusform>
            <numerusform>{count} spigoli i cui triangoli guardano in versi opposti, il primo a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} edges with more than two triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} spigolo con più di due triangoli, a {first:.2f}</numerusform>
            <numerusform>{count} spigoli con più di due triangoli, il primo a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} open edges in {loops} loops, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} spigolo aperto in {loops} contorni, il primo a {first:.2f}</numerusform>
            <numerusform>{count} spigoli aperti in {loops} contorni, il primo a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} pairs of intersecting triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} coppia di triangoli che si tagliano, a {first:.2f}</numerusform>
            <numerusform>{count} coppie di triangoli che si tagliano, la prima a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} triangles without area, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} triangolo senza area, a {first:.2f}</numerusform>
            <numerusform>{count} triangoli senza area, il primo a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} voxels</source>
        <translation>
            <numerusform>{count} voxel</numerusform>
            <numerusform>{count} voxel</numerusform>
        </translation>
    </message>
    <message>
        <source>{file}, byte {byte}</source>
        <translation>{file}, byte {byte}</translation>
    </message>
    <message>
        <source>{file}, line {line}</source>
        <translation>{file}, riga {line}</translation>
    </message>
    <message>
        <source>{file}, line {line}, column {column}</source>
        <translation>{file}, riga {line}, colonna {column}</translation>
    </message>
    <message>
        <source>{first} and {second} collide</source>
        <translation>{first} e {second} si scontrano</translation>
    </message>
    <message>
        <source>{first} collides with {second} in the finished motion</source>
        <translation>{first} urta {second} nel movimento finito</translation>
    </message>
    <message>
        <source>{found} is none of 0, 1 and -</source>
        <translation>{found} non è né 0 né 1 né -</translation>
    </message>
    <message>
        <source>{joint} at {angle:.1f}, beyond its limit of {limit:.1f#}</source>
        <translation>{joint} a {angle:.1f}, oltre il suo limite di {limit:.1f#}</translation>
    </message>
    <message>
        <source>{joint} at {speed:.1f}, above its limit of {limit:.1f#}</source>
        <translation>{joint} a {speed:.1f}, oltre il suo limite di {limit:.1f#}</translation>
    </message>
    <message>
        <source>not covered by layers: {left:.3g#} of {whole:.4g} of the part</source>
        <translation>non coperti da strati: {left:.3g#} di {whole:.4g} del pezzo</translation>
    </message>
    <message numerus="yes">
        <source>{motions} motions from here on are not in the plan</source>
        <translation>
            <numerusform>{motions} movimento da qui in poi non è nel piano</numerusform>
            <numerusform>{motions} movimenti da qui in poi non sono nel piano</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{motions} planned motions are missing before this one</source>
        <translation>
            <numerusform>manca {motions} movimento pianificato prima di questo</numerusform>
            <numerusform>mancano {motions} movimenti pianificati prima di questo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{motions} planned motions are missing between {before} and this one</source>
        <translation>
            <numerusform>manca {motions} movimento pianificato tra {before} e questo</numerusform>
            <numerusform>mancano {motions} movimenti pianificati tra {before} e questo</numerusform>
        </translation>
    </message>
    <message>
        <source>{option}: a value is not finite</source>
        <translation>{option}: un valore non è finito</translation>
    </message>
    <message>
        <source>{option}: {wanted} numbers expected, {given} given</source>
        <translation>{option}: servono {wanted} numeri, dati {given}</translation>
    </message>
    <message>
        <source>{outside:.2f} of the part&apos;s volume is deposited outside it, {noRoom:.2f} does not fit</source>
        <translation>il {outside:.2f} del volume del pezzo è deposto fuori da esso, il {noRoom:.2f} non trova posto</translation>
    </message>
    <message numerus="yes">
        <source>{patches} patches ({area:.1f}) begin in the air: neither the plate nor an earlier layer is below them</source>
        <translation>
            <numerusform>{patches} superficie ({area:.1f}) comincia nel vuoto: sotto non ha né la piastra né uno strato precedente</numerusform>
            <numerusform>{patches} superfici ({area:.1f}) cominciano nel vuoto: sotto non hanno né la piastra né uno strato precedente</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers are left out: too small for a bead, or they would begin in the air ({volume:.1f} in all, the largest {largest:.1f})</source>
        <translation>
            <numerusform>{pieces} parte di uno strato è omessa: troppo piccola per un cordone, o comincerebbe nel vuoto ({volume:.1f})</numerusform>
            <numerusform>{pieces} parti di strati sono omesse: troppo piccole per un cordone, o comincerebbero nel vuoto ({volume:.1f} in tutto, la più grande {largest:.1f})</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers are left out, {volume:.3g} of {whole:.3g#}: too small for a bead, or they would begin in the air</source>
        <translation>
            <numerusform>{pieces} parte di uno strato è omessa, {volume:.3g} di {whole:.3g#}: troppo piccola per un cordone, o comincerebbe nel vuoto</numerusform>
            <numerusform>{pieces} parti di strati sono omesse, {volume:.3g} di {whole:.3g#}: troppo piccole per un cordone, o comincerebbero nel vuoto</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers begin in the air, over neither the rod nor an earlier layer</source>
        <translation>
            <numerusform>una parte di uno strato comincia nel vuoto, né sulla barra né su uno strato precedente</numerusform>
            <numerusform>{pieces} parti di strati cominciano nel vuoto, né sulla barra né su uno strato precedente</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers begin in the air, over neither the surface nor an earlier layer</source>
        <translation>
            <numerusform>una parte di uno strato comincia nel vuoto, né sulla superficie né su uno strato precedente</numerusform>
            <numerusform>{pieces} parti di strati cominciano nel vuoto, né sulla superficie né su uno strato precedente</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers begin in the air</source>
        <translation>
            <numerusform>{pieces} parte di uno strato comincia nel vuoto</numerusform>
            <numerusform>{pieces} parti di strati cominciano nel vuoto</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} places where the program differs from the plan</source>
        <translation>
            <numerusform>{places} punto in cui il programma differisce dal piano</numerusform>
            <numerusform>{places} punti in cui il programma differisce dal piano</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} smaller places are thinner than a voxel of {voxel}; this is the largest, the thinnest is {thinnest:.2f} thick</source>
        <translation>
            <numerusform>{places} punto più piccolo è più sottile di un voxel di {voxel}; è spesso {thinnest:.2f}</numerusform>
            <numerusform>{places} punti più piccoli sono più sottili di un voxel di {voxel}; questo è il più grande, il più sottile è spesso {thinnest:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} smaller places overhang too far, {area:.3g} in all; this is the largest</source>
        <translation>
            <numerusform>{places} punto più piccolo sporge troppo, {area:.3g}</numerusform>
            <numerusform>{places} punti più piccoli sporgono troppo, {area:.3g} in tutto; questo è il più grande</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{place}: no collision-free transfer to {pieces} pieces of paths</source>
        <translation>
            <numerusform>{place}: nessuno spostamento senza collisioni verso {pieces} tratto di percorso</numerusform>
            <numerusform>{place}: nessuno spostamento senza collisioni verso {pieces} tratti di percorso</numerusform>
        </translation>
    </message>
    <message>
        <source>{place}: too far from the rod: the cell prints up to {radius} from its axis and {along} from its middle</source>
        <translation>{place}: troppo lontano dalla barra: la cella stampa fino a {radius} dal suo asse e {along} dalla sua metà</translation>
    </message>
    <message>
        <source>{place}: the print head would cut into the platform</source>
        <translation>{place}: la testina entrerebbe nella piattaforma</translation>
    </message>
    <message>
        <source>{place}: the print head would cut into printed material</source>
        <translation>{place}: la testina entrerebbe nel materiale già stampato</translation>
    </message>
    <message>
        <source>{place}: reachable, but the robot cannot move from or to a neighbouring point without lifting</source>
        <translation>{place}: raggiungibile, ma il robot non può muoversi da o verso un punto vicino senza sollevarsi</translation>
    </message>
    <message>
        <source>{place}: out of the robot&apos;s reach, or beyond a joint limit, at every rotation tried about the nozzle</source>
        <translation>{place}: fuori dalla portata del robot, o oltre un limite di un giunto, a ogni rotazione provata attorno all&apos;ugello</translation>
    </message>
    <message>
        <source>{place}: {first} would collide with {second} at every rotation tried about the nozzle</source>
        <translation>{place}: {first} urterebbe {second} a ogni rotazione provata attorno all&apos;ugello</translation>
    </message>
    <message>
        <source>{points} points do not define a circle: at least three are needed</source>
        <translation>{points} punti non definiscono un cerchio: ne servono almeno tre</translation>
    </message>
    <message>
        <source>{share:.0f} of the layers&apos; area is thinner than {least} or thicker than {most}</source>
        <translation>il {share:.0f} dell&apos;area degli strati è più sottile di {least} o più spesso di {most}</translation>
    </message>
    <message>
        <source>{share:.2f} of the part is not covered by beads, mostly around this point</source>
        <translation>il {share:.2f} del pezzo non è coperto da cordoni, soprattutto attorno a questo punto</translation>
    </message>
    <message>
        <source>{sizes} mm</source>
        <translation>{sizes} mm</translation>
    </message>
    <message>
        <source>{there} of the {promised} facets stated in the header are present</source>
        <translation>ci sono {there} delle {promised} faccette indicate nell&apos;intestazione</translation>
    </message>
    <message>
        <source>{threshold} {value:.4g} (limit {limit:.4g})</source>
        <translation>{threshold} {value:.4g} (limite {limit:.4g})</translation>
    </message>
    <message>
        <source>{value} is outside the limits of process {process}</source>
        <translation>{value} è fuori dai limiti del processo {process}</translation>
    </message>
    <message numerus="yes">
        <source>{voxels} more voxels are missed in smaller groups ({groups}); this is the largest</source>
        <translation>
            <numerusform>manca un altro voxel; è questo</numerusform>
            <numerusform>mancano altri {voxels} voxel in gruppi più piccoli ({groups}); questo è il più grande</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are shadowed: covered by the convex front from step {step} on, under its facet between {a:.0f}, {b:.0f} and {c:.0f} mm</source>
        <translation>
            <numerusform>{voxels} voxel è in ombra: dal passo {step} in poi è coperto dal fronte convesso, sotto la sua faccetta tra {a:.0f}, {b:.0f} e {c:.0f} mm</numerusform>
            <numerusform>{voxels} voxel sono in ombra: dal passo {step} in poi sono coperti dal fronte convesso, sotto la sua faccetta tra {a:.0f}, {b:.0f} e {c:.0f} mm</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are shadowed: covered by the convex front before growth reached them</source>
        <translation>
            <numerusform>{voxels} voxel è in ombra: coperto dal fronte convesso prima che la crescita lo raggiungesse</numerusform>
            <numerusform>{voxels} voxel sono in ombra: coperti dal fronte convesso prima che la crescita li raggiungesse</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are unreached: no path through the part from the platform</source>
        <translation>
            <numerusform>{voxels} voxel non è raggiunto: nessuna via attraverso il pezzo dalla piattaforma</numerusform>
            <numerusform>{voxels} voxel non sono raggiunti: nessuna via attraverso il pezzo dalla piattaforma</numerusform>
        </translation>
    </message>
    <message>
        <source>{voxels} voxels in a grid of {cells} cells need about {needed} of memory; {available} are free</source>
        <translation>{voxels} voxel in una griglia di {cells} celle richiedono circa {needed} di memoria, ne sono liberi {available}</translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are below the plate</source>
        <translation>
            <numerusform>{voxels} voxel sta sotto la piastra</numerusform>
            <numerusform>{voxels} voxel stanno sotto la piastra</numerusform>
        </translation>
    </message>
    <message>
        <source>{where}, entry {number}</source>
        <translation>{where}, voce {number}</translation>
    </message>
    <message>
        <source>Contact area, margin</source>
        <translation>Area di contatto, margine</translation>
    </message>
    <message>
        <source>Rod of the cell</source>
        <translation>Barra della cella</translation>
    </message>
    <message>
        <source>Disc, diameter</source>
        <translation>Disco, diametro</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rettangolo</translation>
    </message>
    <message>
        <source>Rod, diameter × length</source>
        <translation>Barra, diametro × lunghezza</translation>
    </message>
    <message>
        <source>Body from a file</source>
        <translation>Corpo da un file</translation>
    </message>
    <message>
        <source>Margin around the contact area</source>
        <translation>Margine attorno all&apos;area di contatto</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diametro</translation>
    </message>
    <message>
        <source>Width (X)</source>
        <translation>Larghezza (X)</translation>
    </message>
    <message>
        <source>Depth (Y)</source>
        <translation>Profondità (Y)</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
    <message>
        <source>Curved layers</source>
        <translation>Strati curvi</translation>
    </message>
    <message>
        <source>Extended G-code (nozzle direction as nX nY nZ)</source>
        <translation>G-code esteso (direzione dell&apos;ugello come nX nY nZ)</translation>
    </message>
    <message>
        <source>Joint table (CSV)</source>
        <translation>Tabella dei giunti (CSV)</translation>
    </message>
    <message>
        <source>contact area</source>
        <translation>area di contatto</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatica</translation>
    </message>
    <message>
        <source>Peels the part and keeps the best of several passes</source>
        <translation>Sbuccia il pezzo e tiene il migliore di più passaggi</translation>
    </message>
    <message>
        <source>Reverse peeling</source>
        <translation>Sbucciatura inversa</translation>
    </message>
    <message>
        <source>Removes voxels from outside while the rest stays supported; printed in the opposite order</source>
        <translation>Toglie voxel dall&apos;esterno finché il resto resta sostenuto; si stampa nell&apos;ordine opposto</translation>
    </message>
    <message>
        <source>Guided by peeling</source>
        <translation>Guidata</translation>
    </message>
    <message>
        <source>Grows from the platform, held back by the peeling field</source>
        <translation>Cresce dalla piattaforma, trattenuta dal campo di sbucciatura</translation>
    </message>
    <message>
        <source>Halved layers</source>
        <translation>A strati dimezzati</translation>
    </message>
    <message>
        <source>Grows from the platform; a layer that would shadow voxels is halved until it does not</source>
        <translation>Cresce dalla piattaforma; uno strato che isolerebbe dei voxel viene dimezzato finché non lo fa più</translation>
    </message>
    <message>
        <source>Voxel by voxel</source>
        <translation>Voxel per voxel</translation>
    </message>
    <message>
        <source>Grows from the platform; a layer takes each voxel that shadows no other</source>
        <translation>Cresce dalla piattaforma; uno strato prende ogni voxel che non ne isola altri</translation>
    </message>
    <message>
        <source>Greedy</source>
        <translation>Golosa</translation>
    </message>
    <message>
        <source>Grows from the platform by whole layers, whatever they shadow</source>
        <translation>Cresce dalla piattaforma a strati interi, qualunque cosa isolino</translation>
    </message>
    <message>
        <source>Drop to plate</source>
        <translation>Appoggia sul piatto</translation>
    </message>
    <message>
        <source>Lowers the part onto the plate</source>
        <translation>Abbassa il pezzo sul piatto</translation>
    </message>
    <message>
        <source>Shrink platform</source>
        <translation>Riduci la piattaforma</translation>
    </message>
    <message>
        <source>To the part&apos;s contact area, which narrows the front</source>
        <translation>All&apos;area di contatto del pezzo, che restringe il fronte</translation>
    </message>
    <message>
        <source>Add supports</source>
        <translation>Aggiungi supporti</translation>
    </message>
    <message>
        <source>As few thin break-away columns as possible</source>
        <translation>Il minor numero possibile di colonne sottili da staccare</translation>
    </message>
    <message>
        <source>Turn the part</source>
        <translation>Gira il pezzo</translation>
    </message>
    <message>
        <source>Searches the orientation with the fewest missed voxels</source>
        <translation>Cerca l&apos;orientamento con il minor numero di voxel mancati</translation>
    </message>
    <message>
        <source>Narrow enough for this wall; narrower voxels take longer</source>
        <translation>Abbastanza stretti per questa parete; voxel più stretti richiedono più tempo</translation>
    </message>
    <message>
        <source>Planar pieces</source>
        <translation>Pezzi piani</translation>
    </message>
    <message>
        <source>Flat layers</source>
        <translation>Strati piani</translation>
    </message>
    <message>
        <source>Widen the platform</source>
        <translation>Allarga la base</translation>
    </message>
    <message>
        <source>By 20 mm on all sides, to give supports a base</source>
        <translation>Di 20 mm su tutti i lati, per dare base ai supporti</translation>
    </message>
    <message>
        <source>Adapt the layers</source>
        <translation>Adatta gli strati</translation>
    </message>
    <message>
        <source>Thinner layers on sloping surfaces, to reduce the gaps at steps</source>
        <translation>Strati più sottili sulle superfici inclinate, per ridurre i vuoti dei gradini</translation>
    </message>
    <message>
        <source>Searches the orientation with the smallest area to support</source>
        <translation>Cerca l&apos;orientamento con la minore area da sostenere</translation>
    </message>
    <message>
        <source>Around a rod</source>
        <translation>Intorno a una barra</translation>
    </message>
    <message>
        <source>On a given surface</source>
        <translation>Su una superficie data</translation>
    </message>
    <message>
        <source>repair the mesh, or use curved mode, which takes any mesh</source>
        <translation>ripara la mesh, o usa la modalità curva, che accetta qualsiasi mesh</translation>
    </message>
    <message>
        <source>a planar section of the mesh crosses itself</source>
        <translation>una sezione piana della mesh interseca se stessa</translation>
    </message>
    <message>
        <source>EGL cannot be initialized</source>
        <translation>EGL non può essere inizializzato</translation>
    </message>
    <message>
        <source>EGL does not support platform displays</source>
        <translation>EGL non supporta gli schermi di piattaforma</translation>
    </message>
    <message>
        <source>its functions were not found</source>
        <translation>le sue funzioni non sono state trovate</translation>
    </message>
    <message>
        <source>no context can be made</source>
        <translation>non si può creare un contesto</translation>
    </message>
    <message>
        <source>the context cannot be used</source>
        <translation>il contesto non si può usare</translation>
    </message>
    <message>
        <source>Plate of the cell</source>
        <translation>Piastra della cella</translation>
    </message>
    <message>
        <source>cell {cell} has no plates</source>
        <translation>la cella {cell} non ha piastre</translation>
    </message>
    <message>
        <source>choose another platform, or another cell</source>
        <translation>scegliere un&apos;altra piattaforma, o un&apos;altra cella</translation>
    </message>
    <message>
        <source>copy it to a file first</source>
        <translation>copiarlo prima in un file</translation>
    </message>
    <message>
        <source>give `--platform disc:DIAMETER`, or another platform</source>
        <translation>indicare `--platform disc:DIAMETER`, o un&apos;altra piattaforma</translation>
    </message>
    <message>
        <source>is not a regular file, but a device or a pipe</source>
        <translation>non è un file ordinario, ma un dispositivo o una pipe</translation>
    </message>
    <message>
        <source>check these places in the view; turn the part if they matter</source>
        <translation>controlla questi punti nella vista; gira il pezzo se contano</translation>
    </message>
    <message>
        <source>no way of building supports platform {platform} in cell {cell}</source>
        <translation>nessun modo di costruire supporta la piattaforma {platform} nella cella {cell}</translation>
    </message>
    <message>
        <source>plate of the cell</source>
        <translation>piastra della cella</translation>
    </message>
    <message>
        <source>transfers</source>
        <translation>spostamenti</translation>
    </message>
    <message>
        <source>{place}: skipped, because of a collision on the way to it</source>
        <translation>{place}: saltato, per una collisione durante il percorso fin lì</translation>
    </message>
    <message numerus="yes">
        <source>{place}: no collision-free transfer away from the ends of {pieces} pieces of paths</source>
        <translation>
            <numerusform>{place}: nessuno spostamento senza collisioni dalla fine di {pieces} tratto di percorso</numerusform>
            <numerusform>{place}: nessuno spostamento senza collisioni dalle fini di {pieces} tratti di percorso</numerusform>
        </translation>
    </message>
    <message>
        <source>a mesh with defects cannot be cut into pieces</source>
        <translation>una mesh con difetti non può essere divisa in pezzi</translation>
    </message>
    <message>
        <source>&apos;{units}&apos; is not a unit of length</source>
        <translation>&apos;{units}&apos; non è un&apos;unità di lunghezza</translation>
    </message>
    <message>
        <source>Scales it by 25.4</source>
        <translation>Lo scala di 25,4</translation>
    </message>
    <message>
        <source>Scales it by 1000</source>
        <translation>Lo scala di 1000</translation>
    </message>
    <message>
        <source>Scales it by 0.001</source>
        <translation>Lo scala di 0,001</translation>
    </message>
    <message>
        <source>Large enough for the narrowest bead</source>
        <translation>Grande abbastanza per il cordone più stretto</translation>
    </message>
    <message>
        <source>The largest scale within the robot&apos;s reach</source>
        <translation>La scala massima raggiungibile dal robot</translation>
    </message>
    <message>
        <source>Centre the part</source>
        <translation>Centra il pezzo</translation>
    </message>
    <message>
        <source>The file is in inches</source>
        <translation>Il file è in pollici</translation>
    </message>
    <message>
        <source>The file is in metres</source>
        <translation>Il file è in metri</translation>
    </message>
    <message>
        <source>The file is in micrometres</source>
        <translation>Il file è in micrometri</translation>
    </message>
    <message>
        <source>On the platform&apos;s position</source>
        <translation>Sulla posizione della piattaforma</translation>
    </message>
    <message>
        <source>Print at scale {scale}</source>
        <translation>Stampa in scala {scale}</translation>
    </message>
    <message>
        <source>Scale to fit</source>
        <translation>Adatta la scala</translation>
    </message>
    <message>
        <source>Use a finer process</source>
        <translation>Usa un processo più fine</translation>
    </message>
    <message>
        <source>With the widest bead that fits these walls</source>
        <translation>Con il cordone più largo che entra in queste pareti</translation>
    </message>
    <message>
        <source>give one of {known}</source>
        <translation>indicare uno di {known}</translation>
    </message>
    <message>
        <source>give the units it was drawn in (`--units`)</source>
        <translation>indicare le unità in cui è stato disegnato (`--units`)</translation>
    </message>
    <message>
        <source>centre the part, or use a platform that reaches its support</source>
        <translation>metti il pezzo al centro, o usa una piattaforma che arrivi al sostegno</translation>
    </message>
    <message>
        <source>print it at scale {scale}, or use a process with narrower beads</source>
        <translation>stampalo in scala {scale}, o usa un processo con cordoni più stretti</translation>
    </message>
    <message>
        <source>print it smaller (`--scale fit`), or give the units it was drawn in (`--units`)</source>
        <translation>stamparlo più piccolo (`--scale fit`), o indicare le unità in cui è stato disegnato (`--units`)</translation>
    </message>
    <message>
        <source>the part is very small: {size:.3g} long if its file is in millimetres</source>
        <translation>il pezzo è molto piccolo: è lungo {size:.3g} se il suo file è in millimetri</translation>
    </message>
    <message>
        <source>the part is very large: {size:.4g} long if its file is in millimetres</source>
        <translation>il pezzo è molto grande: è lungo {size:.4g} se il suo file è in millimetri</translation>
    </message>
    <message>
        <source>platform {distance:.0f} beside its support: it would float</source>
        <translation>piattaforma a {distance:.0f} dal suo sostegno: resterebbe sospesa</translation>
    </message>
    <message>
        <source>use a process with narrower beads; scaled up enough, the part is out of the robot&apos;s reach</source>
        <translation>usa un processo con cordoni più stretti; ingrandito quanto serve, il pezzo è fuori dalla portata del robot</translation>
    </message>
    <message>
        <source>{share:.3g} of the part is thinner than the narrowest bead ({least}); most of it is {usual:.2f} thick</source>
        <translation>il {share:.3g} del pezzo è più sottile del cordone più stretto ({least}); per lo più è spesso {usual:.2f}</translation>
    </message>
    <message>
        <source>Use best orientation</source>
        <translation>Usa l&apos;orientamento migliore</translation>
    </message>
    <message>
        <source>Most contact relative to the overhang, and fewest missed voxels</source>
        <translation>Massimo contatto rispetto allo sbalzo e minor numero di voxel mancati</translation>
    </message>
    <message>
        <source>give degrees about x, y and z: 90,0,0</source>
        <translation>indica i gradi attorno a x, y e z: 90,0,0</translation>
    </message>
    <message>
        <source>use that orientation, turned by {x:.3g} about x, {y:.3g} about y and {z:.3g} about z, or choose another one</source>
        <translation>usa quell&apos;orientamento, girando di {x:.3g} attorno a x, {y:.3g} attorno a y e {z:.3g} attorno a z, oppure scegline un altro</translation>
    </message>
    <message>
        <source>poor orientation: contact {contact:.0f}, overhang {overhang:.0f}, {missed:.2g} of the voxels missed; another orientation has contact {bestContact:.0f}, overhang {bestOverhang:.0f}, {bestMissed:.2g} missed</source>
        <translation>orientamento sfavorevole: appoggio {contact:.0f}, sbalzo {overhang:.0f}, {missed:.2g} dei voxel mancati; un altro orientamento ha appoggio {bestContact:.0f}, sbalzo {bestOverhang:.0f}, {bestMissed:.2g} mancati</translation>
    </message>
    <message>
        <source>turn &apos;{turn}&apos; is not three angles</source>
        <translation>la rotazione «{turn}» non è fatta di tre angoli</translation>
    </message>
    <message>
        <source>orientations</source>
        <translation>orientamenti</translation>
    </message>
    <message>
        <source>{length:.1f} of a bead is unsupported; this material bridges {bridge:.1f}</source>
        <translation>{length:.1f} di un cordone non sono sostenuti; questo materiale ne scavalca {bridge:.1f}</translation>
    </message>
    <message>
        <source>use a pedestal made for the part: it leaves room for the print head; a drawing of it is written</source>
        <translation>usa un piedistallo fatto per il pezzo: lascia spazio alla testa; ne viene scritto il disegno</translation>
    </message>
    <message numerus="yes">
        <source>without columns, {here} voxels would be missed on this plate, {there} on a pedestal as wide as the part&apos;s footprint</source>
        <translation>
            <numerusform>senza colonne, su questo piano si perderebbe {here} voxel, su un piedistallo largo quanto la base del pezzo {there}</numerusform>
            <numerusform>senza colonne, su questo piano si perderebbero {here} voxel, su un piedistallo largo quanto la base del pezzo {there}</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;unitfactor&apos; is not above 0</source>
        <translation>«unitfactor» non è maggiore di 0</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not above 0, or too large</source>
        <translation>«{attribute}» non è maggiore di 0, o è troppo grande</translation>
    </message>
    <message>
        <source>&apos;{element}&apos; outside tool-paths</source>
        <translation>«{element}» fuori dai percorsi</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; calls itself</source>
        <translation>«{name}» richiama sé stessa</translation>
    </message>
    <message>
        <source>invalid call of &apos;{name}&apos;</source>
        <translation>chiamata di «{name}» non valida</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; needs a mass</source>
        <translation>«{name}» richiede una massa</translation>
    </message>
    <message>
        <source>&apos;{path}&apos; is not the name of a part in the package</source>
        <translation>«{path}» non è il nome di una parte del pacchetto</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not allowed here: it changes the machine during the print</source>
        <translation>«{word}» non è ammesso qui: cambia la macchina durante la stampa</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; slows the arm: the flow would not follow</source>
        <translation>«{word}» rallenta il braccio: il flusso non lo seguirebbe</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; sets a different load</source>
        <translation>«{word}» imposta un carico diverso</translation>
    </message>
    <message>
        <source>Prints a file along its own tool-paths (.build.3mf, .gcode). Off: plans new ones for its object.</source>
        <translation>Stampa un file lungo i suoi percorsi (.build.3mf, .gcode). Spento: ne pianifica di nuovi per il suo oggetto.</translation>
    </message>
    <message>
        <source>Adds NAME.build.3mf: the plan&apos;s 6-axis tool-paths for other programs (3MF Toolpath Extension).</source>
        <translation>Aggiunge NAME.build.3mf: i percorsi del piano a 6 assi per altri programmi (3MF Toolpath Extension).</translation>
    </message>
    <message>
        <source>IRC5: .mod</source>
        <translation>IRC5: .mod</translation>
    </message>
    <message>
        <source>OmniCore: .modx</source>
        <translation>OmniCore: .modx</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programmi</translation>
    </message>
    <message>
        <source>RAPID modules</source>
        <translation>Moduli RAPID</translation>
    </message>
    <message>
        <source>URScript for</source>
        <translation>URScript per</translation>
    </message>
    <message>
        <source>a TriggL before its TriggEquip</source>
        <translation>un TriggL prima del suo TriggEquip</translation>
    </message>
    <message>
        <source>a bead is printed by a joint motion instead of a straight one</source>
        <translation>un cordone è stampato con un moto ai giunti invece di uno rettilineo</translation>
    </message>
    <message>
        <source>unexpected control character: is this a binary file?</source>
        <translation>carattere di controllo inatteso: è un file binario?</translation>
    </message>
    <message>
        <source>use a larger nozzle, or slower tool-paths</source>
        <translation>usa un ugello più grande, o percorsi più lenti</translation>
    </message>
    <message>
        <source>a modifier of &apos;{attribute}&apos; without a range above 0 or without a factor of e, f, g and h</source>
        <translation>un modificatore di «{attribute}» senza intervallo sopra 0 o senza fattore tra e, f, g e h</translation>
    </message>
    <message>
        <source>an unsupported modifier of &apos;{attribute}&apos;</source>
        <translation>un modificatore non supportato di «{attribute}»</translation>
    </message>
    <message>
        <source>a modifier of &apos;{attribute}&apos;, which its profile lacks</source>
        <translation>un modificatore di «{attribute}», che manca al suo profilo</translation>
    </message>
    <message>
        <source>a modifier of unknown type &apos;{type}&apos;</source>
        <translation>un modificatore di tipo sconosciuto «{type}»</translation>
    </message>
    <message>
        <source>a modifier outside a profile</source>
        <translation>un modificatore fuori da un profilo</translation>
    </message>
    <message>
        <source>a point more than a kilometre away</source>
        <translation>un punto a più di un chilometro</translation>
    </message>
    <message>
        <source>a point&apos;s frame has no direction</source>
        <translation>il riferimento di un punto non ha direzione</translation>
    </message>
    <message>
        <source>a second call outside the functions</source>
        <translation>una seconda chiamata fuori dalle funzioni</translation>
    </message>
    <message>
        <source>a segment of fewer than two points</source>
        <translation>un segmento di meno di due punti</translation>
    </message>
    <message>
        <source>a segment of type &apos;{type}&apos; among tool-paths of {axes} axes</source>
        <translation>un segmento di tipo «{type}» tra percorsi a {axes} assi</translation>
    </message>
    <message>
        <source>a modifier&apos;s support point outside a point</source>
        <translation>un punto d&apos;appoggio di un modificatore fuori da un punto</translation>
    </message>
    <message>
        <source>threads are not supported</source>
        <translation>i thread non sono supportati</translation>
    </message>
    <message>
        <source>a tool-path is beyond the range of a build file</source>
        <translation>un percorso è oltre l&apos;intervallo di un file di costruzione</translation>
    </message>
    <message>
        <source>a work object moved by both robot and external axis is not supported</source>
        <translation>un oggetto di lavoro mosso sia dal robot sia da un asse esterno non è supportato</translation>
    </message>
    <message>
        <source>an unexpected {point}</source>
        <translation>un {point} inatteso</translation>
    </message>
    <message>
        <source>a tool other than the printing one</source>
        <translation>un utensile diverso da quello che stampa</translation>
    </message>
    <message>
        <source>requires the unknown extension &apos;{name}&apos;</source>
        <translation>richiede l&apos;estensione sconosciuta «{name}»</translation>
    </message>
    <message>
        <source>at the controller&apos;s speeds, {share:.2f} of the bead length gets over 5 % too much or too little material</source>
        <translation>alle velocità del controllore, il {share:.2f} della lunghezza dei cordoni riceve oltre il 5 % di materiale in più o in meno</translation>
    </message>
    <message>
        <source>bead {bead}</source>
        <translation>cordone {bead}</translation>
    </message>
    <message>
        <source>choose an earlier or a later bead</source>
        <translation>scegli un cordone precedente o successivo</translation>
    </message>
    <message>
        <source>choose an earlier place</source>
        <translation>scegliere un punto precedente</translation>
    </message>
    <message>
        <source>factors of &apos;{attribute}&apos; are finer than its modifier&apos;s type allows</source>
        <translation>i fattori di «{attribute}» sono più fini di quanto ammette il tipo del modificatore</translation>
    </message>
    <message>
        <source>from the front (x to the right, z up)</source>
        <translation>di fronte (x a destra, z in alto)</translation>
    </message>
    <message>
        <source>from the side (y to the right, z up)</source>
        <translation>di lato (y a destra, z in alto)</translation>
    </message>
    <message>
        <source>give --program</source>
        <translation>indicare --program</translation>
    </message>
    <message>
        <source>give --program, a file from {first} to {last}</source>
        <translation>indicare --program, un file da {first} a {last}</translation>
    </message>
    <message>
        <source>choose the process that the tool-paths were made for</source>
        <translation>scegli il processo per cui i percorsi sono stati fatti</translation>
    </message>
    <message>
        <source>gravity of an arm that is not upright</source>
        <translation>gravità di un braccio non in piedi</translation>
    </message>
    <message>
        <source>has a document type, which is not accepted</source>
        <translation>ha un tipo di documento, che non è accettato</translation>
    </message>
    <message>
        <source>contains neither an object nor beads with width and height</source>
        <translation>non contiene né un oggetto né cordoni con larghezza e altezza</translation>
    </message>
    <message>
        <source>contains no tool-paths</source>
        <translation>non contiene percorsi</translation>
    </message>
    <message>
        <source>exceeds the limit of a joint of the robot</source>
        <translation>supera il limite di un giunto del robot</translation>
    </message>
    <message>
        <source>is not a layer of tool-paths</source>
        <translation>non è uno strato di percorsi</translation>
    </message>
    <message>
        <source>leave scale and units as they are, or give `givenToolPaths=false`</source>
        <translation>lasciare scala e unità come sono, o dare `givenToolPaths=false`</translation>
    </message>
    <message>
        <source>line {line} is ambiguous: the program has {count} files</source>
        <translation>la riga {line} è ambigua: il programma ha {count} file</translation>
    </message>
    <message>
        <source>mixed line ends: they differ from here on</source>
        <translation>fini riga misti: da qui in poi sono diversi</translation>
    </message>
    <message>
        <source>too much for a zip file</source>
        <translation>troppo per un file zip</translation>
    </message>
    <message>
        <source>more tool-path points than can be planned</source>
        <translation>più punti di quanti se ne possano pianificare</translation>
    </message>
    <message>
        <source>motions per file</source>
        <translation>movimenti per file</translation>
    </message>
    <message>
        <source>near singular poses the arm would deviate from the planned orientation</source>
        <translation>vicino alle singolarità il braccio lascerebbe l&apos;orientamento previsto</translation>
    </message>
    <message>
        <source>no motion at or after line {line}</source>
        <translation>nessun movimento alla riga {line} o dopo di essa</translation>
    </message>
    <message>
        <source>no object in the file: the part is made from its beads</source>
        <translation>nessun oggetto nel file: il pezzo è ricavato dai suoi cordoni</translation>
    </message>
    <message>
        <source>not a program of this job</source>
        <translation>non è un programma di questo lavoro</translation>
    </message>
    <message>
        <source>not the definition of a function without arguments</source>
        <translation>non è la definizione di una funzione senza argomenti</translation>
    </message>
    <message>
        <source>nothing is printed after that place</source>
        <translation>da lì in poi non si stampa nulla</translation>
    </message>
    <message>
        <source>the first of {count} sets of tool-paths was taken</source>
        <translation>è stato preso il primo di {count} insiemi di percorsi</translation>
    </message>
    <message>
        <source>flow changes are only supported at the start of a motion</source>
        <translation>i cambi di flusso sono supportati solo all&apos;inizio di un movimento</translation>
    </message>
    <message>
        <source>use the program for the cell&apos;s own controller</source>
        <translation>usare il programma del controllore della cella</translation>
    </message>
    <message>
        <source>stated payload {mass:.2f} kg, planned about {planned:.2f} kg</source>
        <translation>carico dichiarato {mass:.2f} kg, previsto circa {planned:.2f} kg</translation>
    </message>
    <message>
        <source>the beads are too thin to be filled with cells</source>
        <translation>i cordoni sono troppo sottili per essere riempiti di celle</translation>
    </message>
    <message>
        <source>the beads extend too far to be filled with cells</source>
        <translation>i cordoni si estendono troppo per essere riempiti di celle</translation>
    </message>
    <message>
        <source>the build&apos;s tool-paths {id} are missing</source>
        <translation>mancano i percorsi {id} della costruzione</translation>
    </message>
    <message>
        <source>the factor &apos;{factor}&apos; is given twice</source>
        <translation>il fattore «{factor}» è dato due volte</translation>
    </message>
    <message>
        <source>the factor &apos;{factor}&apos; is not within 0 and 1</source>
        <translation>il fattore «{factor}» non è tra 0 e 1</translation>
    </message>
    <message>
        <source>the file begins with a byte-order mark: save it as plain text</source>
        <translation>il file inizia con un BOM: salvarlo come testo semplice</translation>
    </message>
    <message numerus="yes">
        <source>the file gives no width, height or speed for {points} points of its tool-paths: taken from process {process}</source>
        <translation>
            <numerusform>il file non indica larghezza, altezza o velocità di {points} punto dei suoi percorsi: prese dal processo {process}</numerusform>
            <numerusform>il file non indica larghezza, altezza o velocità di {points} punti dei suoi percorsi: prese dal processo {process}</numerusform>
        </translation>
    </message>
    <message>
        <source>the first motion is too fast: it begins at an unknown pose of the arm</source>
        <translation>il primo movimento è troppo veloce: comincia da una posa ignota del braccio</translation>
    </message>
    <message>
        <source>the frames of tool-paths point into the part; they were reversed</source>
        <translation>i riferimenti dei percorsi puntano dentro il pezzo; sono stati invertiti</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; is defined twice</source>
        <translation>la funzione «{defined}» è definita due volte</translation>
    </message>
    <message>
        <source>the job has no program to take the line from</source>
        <translation>il lavoro non ha un programma a cui la riga possa appartenere</translation>
    </message>
    <message>
        <source>the job has no motion to resume</source>
        <translation>il lavoro non contiene un moto da riprendere</translation>
    </message>
    <message>
        <source>layer &apos;{path}&apos; is not related to the model</source>
        <translation>lo strato «{path}» non è collegato al modello</translation>
    </message>
    <message>
        <source>duplicate layer &apos;{path}&apos;</source>
        <translation>strato «{path}» duplicato</translation>
    </message>
    <message>
        <source>computing the part printed so far</source>
        <translation>calcolo del pezzo stampato finora</translation>
    </message>
    <message>
        <source>the part {id} of a segment is not in its layer</source>
        <translation>la parte {id} di un segmento non è nel suo strato</translation>
    </message>
    <message>
        <source>the profile &apos;{uuid}&apos; is not in the model</source>
        <translation>il profilo «{uuid}» non è nel modello</translation>
    </message>
    <message>
        <source>duplicate profile &apos;{uuid}&apos;</source>
        <translation>profilo «{uuid}» duplicato</translation>
    </message>
    <message>
        <source>the profile {id} of a segment is not in its layer</source>
        <translation>il profilo {id} di un segmento non è nel suo strato</translation>
    </message>
    <message>
        <source>the robot must hold either the tool or the work object</source>
        <translation>il robot deve tenere o l&apos;utensile o l&apos;oggetto di lavoro</translation>
    </message>
    <message>
        <source>a modifier&apos;s support points do not increase between 0 and 1</source>
        <translation>i punti d&apos;appoggio di un modificatore non crescono tra 0 e 1</translation>
    </message>
    <message>
        <source>the tool-paths of the part&apos;s file are damaged</source>
        <translation>i percorsi del file del pezzo sono danneggiati</translation>
    </message>
    <message>
        <source>unknown unit &apos;{unit}&apos;</source>
        <translation>unità «{unit}» sconosciuta</translation>
    </message>
    <message>
        <source>the {format} program, for another controller, is not released: {failed}</source>
        <translation>il programma {format}, per un altro controllore, non viene consegnato: {failed}</translation>
    </message>
    <message>
        <source>no bead {bead}: the plan has {beads} beads</source>
        <translation>il cordone {bead} non esiste: il piano ha {beads} cordoni</translation>
    </message>
    <message>
        <source>commanded acceleration is {times:.1f} times the planned one</source>
        <translation>l&apos;accelerazione comandata è {times:.1f} volte quella prevista</translation>
    </message>
    <message>
        <source>the tool-paths of a file cannot be scaled</source>
        <translation>i percorsi di un file non si possono scalare</translation>
    </message>
    <message>
        <source>tool-paths of the file</source>
        <translation>percorsi del file</translation>
    </message>
    <message>
        <source>two modifiers of &apos;{attribute}&apos; or with the same factor</source>
        <translation>due modificatori di «{attribute}» o con lo stesso fattore</translation>
    </message>
    <message>
        <source>unpacks to an implausible size</source>
        <translation>si espande a una dimensione implausibile</translation>
    </message>
    <message>
        <source>unparsed text in a layer&apos;s data</source>
        <translation>testo non analizzato nei dati di uno strato</translation>
    </message>
    <message>
        <source>unparsed text in a tool-path&apos;s data</source>
        <translation>testo non analizzato nei dati di un percorso</translation>
    </message>
    <message>
        <source>waits before and after tool-paths are left out</source>
        <translation>le attese prima e dopo i percorsi sono tralasciate</translation>
    </message>
    <message>
        <source>write a build file</source>
        <translation>scrivi un file di costruzione</translation>
    </message>
    <message>
        <source>write verification reports</source>
        <translation>scrivi i rapporti di verifica</translation>
    </message>
    <message>
        <source>write the program again, with times instead of speeds where the format supports them</source>
        <translation>scrivi di nuovo il programma, con tempi al posto delle velocità dove il formato li ammette</translation>
    </message>
    <message>
        <source>{celsius} °C is outside the printing range of {material}</source>
        <translation>{celsius} °C è fuori dall&apos;intervallo di stampa di {material}</translation>
    </message>
    <message>
        <source>{length:.0f} of filament retracted: out of the hot end</source>
        <translation>{length:.0f} di filamento ritratti: fuori dall&apos;ugello</translation>
    </message>
    <message>
        <source>{part}: verification report of the {format} program</source>
        <translation>{part}: rapporto di verifica del programma {format}</translation>
    </message>
    <message>
        <source>{place}: no collision-free transfer from home to the place where the print resumes</source>
        <translation>{place}: nessuno spostamento senza collisioni dalla posizione di riposo al punto in cui la stampa riprende</translation>
    </message>
    <message numerus="yes">
        <source>{points} points of the file&apos;s tool-paths need more flow than the extruder&apos;s limit of {limit}: printed slower</source>
        <translation>
            <numerusform>{points} punto dei percorsi del file richiede più flusso dei {limit} dell&apos;estrusore: stampato più lentamente</numerusform>
            <numerusform>{points} punti dei percorsi del file richiedono più flusso dei {limit} dell&apos;estrusore: stampati più lentamente</numerusform>
        </translation>
    </message>
    <message>
        <source>{volume:.3f} is extruded before the first bead instead of {planned:.3f}</source>
        <translation>prima del primo cordone vengono estrusi {volume:.3f} invece di {planned:.3f}</translation>
    </message>
    <message>
        <source>{volume:.3f} is extruded here while the nozzle does not move for {time:.3f}</source>
        <translation>qui escono {volume:.3f} mentre l&apos;ugello sta fermo per {time:.3f}</translation>
    </message>
    <message>
        <source>$APO.CDIS is not set before this motion</source>
        <translation>$APO.CDIS non è impostato prima di questo movimento</translation>
    </message>
    <message>
        <source>$IPO_MODE must be #BASE or #TCP</source>
        <translation>$IPO_MODE dev&apos;essere #BASE o #TCP</translation>
    </message>
    <message>
        <source>$VEL.CP is not set before this motion</source>
        <translation>$VEL.CP non è impostato prima di questo movimento</translation>
    </message>
    <message>
        <source>&apos;ChangeTCP&apos; between PVTEnter and PVTExit</source>
        <translation>&apos;ChangeTCP&apos; fra PVTEnter e PVTExit</translation>
    </message>
    <message>
        <source>&apos;Cnt&apos; is 0, or 1 with two distances</source>
        <translation>&apos;Cnt&apos; è 0, oppure 1 con due distanze</translation>
    </message>
    <message>
        <source>&apos;Dly&apos; without a time in seconds</source>
        <translation>&apos;Dly&apos; senza un tempo in secondi</translation>
    </message>
    <message>
        <source>&apos;EMvs&apos; without work coordinates 1 to 8</source>
        <translation>&apos;EMvs&apos; senza coordinate di lavoro da 1 a 8</translation>
    </message>
    <message>
        <source>&apos;Mvs&apos; and &apos;EMvs&apos; in one program: only one of them can move the nozzle</source>
        <translation>&apos;Mvs&apos; ed &apos;EMvs&apos; nello stesso programma: solo uno dei due può muovere l&apos;ugello</translation>
    </message>
    <message>
        <source>&apos;PTP&apos; in millimetres per second</source>
        <translation>&apos;PTP&apos; in millimetri al secondo</translation>
    </message>
    <message>
        <source>&apos;PVTEnter&apos; needs 0 (joints) or 1 (poses)</source>
        <translation>&apos;PVTEnter&apos; vuole 0 (giunti) oppure 1 (pose)</translation>
    </message>
    <message>
        <source>&apos;PVTEnter&apos; without PVTExit before it</source>
        <translation>&apos;PVTEnter&apos; senza PVTExit prima</translation>
    </message>
    <message>
        <source>&apos;PVTExit&apos; is missing before the end</source>
        <translation>&apos;PVTExit&apos; manca prima della fine</translation>
    </message>
    <message>
        <source>&apos;PVTExit&apos; without PVTEnter before it</source>
        <translation>&apos;PVTExit&apos; senza PVTEnter prima</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; needs six positions, six velocities and a time in seconds</source>
        <translation>&apos;PVTPoint&apos; vuole sei posizioni, sei velocità e un tempo in secondi</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; with an invalid time or velocity</source>
        <translation>&apos;PVTPoint&apos; con un tempo o una velocità non validi</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; without PVTEnter before it</source>
        <translation>&apos;PVTPoint&apos; senza PVTEnter prima</translation>
    </message>
    <message>
        <source>&apos;Wth&apos; without an output</source>
        <translation>&apos;Wth&apos; senza un&apos;uscita</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; without a sensible value</source>
        <translation>&apos;{name}&apos; senza un valore sensato</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is a frame that only the controller knows</source>
        <translation>&apos;{word}&apos; è un riferimento che solo il controllore conosce</translation>
    </message>
    <message>
        <source>Motions shorter than {time} ms are stretched to that time and their flow is reduced to match.</source>
        <translation>I movimenti più brevi di {time} ms vengono allungati a quel tempo e il loro flusso ridotto in proporzione.</translation>
    </message>
    <message>
        <source>Corners are passed without a stop, as if rounded by an arc with a deviation of {distance:.3g}.</source>
        <translation>Gli spigoli si passano senza sosta, come arrotondati da un arco con uno scarto di {distance:.3g}.</translation>
    </message>
    <message>
        <source>E1 is missing: an external axis moves the base</source>
        <translation>Manca E1: un asse esterno muove la base</translation>
    </message>
    <message>
        <source>ENDDAT is missing: the file was cut short</source>
        <translation>Manca ENDDAT: il file è stato troncato</translation>
    </message>
    <message>
        <source>G-code with B and C (a table that tilts and turns)</source>
        <translation>G-code con B e C (una tavola che si inclina e gira)</translation>
    </message>
    <message>
        <source>G-code with B and C: X distance of the plate&apos;s centre from the tilt axis.</source>
        <translation>G-code con B e C: distanza in X del centro del piatto dall&apos;asse di inclinazione.</translation>
    </message>
    <message>
        <source>G-code with B and C: height of the plate&apos;s top above the tilt axis.</source>
        <translation>G-code con B e C: altezza della faccia del piatto sopra l&apos;asse di inclinazione.</translation>
    </message>
    <message>
        <source>G-code with B and C: whether B and C are the right-handed rotation of the part, or that of the tool around a fixed part.</source>
        <translation>G-code con B e C: se B e C sono la rotazione destrorsa del pezzo, o quella dell&apos;utensile attorno a un pezzo fermo.</translation>
    </message>
    <message>
        <source>Joint speeds are in percent: 100 % is assumed to be 180 degrees/s, so the times of these travels are estimates.</source>
        <translation>Le velocità dei giunti sono in percentuale: il 100 % si assume pari a 180 gradi/s, quindi i tempi di quegli spostamenti sono stime.</translation>
    </message>
    <message>
        <source>Joints accelerate at {acceleration:.0f}/s2 unless the program states otherwise.</source>
        <translation>I giunti accelerano a {acceleration:.0f}/s2 se il programma non indica altro.</translation>
    </message>
    <message>
        <source>KRL (KUKA)</source>
        <translation>KRL (KUKA)</translation>
    </message>
    <message>
        <source>KRL memory</source>
        <translation>memoria KRL</translation>
    </message>
    <message>
        <source>MELFA-BASIC V (Mitsubishi)</source>
        <translation>MELFA-BASIC V (Mitsubishi)</translation>
    </message>
    <message>
        <source>Programmed accelerations are used; where none is given, motion starts instantly.</source>
        <translation>Si usano le accelerazioni programmate; dove non sono date, il movimento parte di colpo.</translation>
    </message>
    <message>
        <source>No motion is shorter than the controller&apos;s cycle of {cycle} ms.</source>
        <translation>Nessun movimento dura meno del ciclo del controllore, {cycle} ms.</translation>
    </message>
    <message>
        <source>Not tested on a machine: start slowly, with a cold extruder.</source>
        <translation>Non provato su una macchina: cominciare piano, con l&apos;estrusore freddo.</translation>
    </message>
    <message>
        <source>Plain G-code (three axes, flat jobs)</source>
        <translation>G-code semplice (tre assi, lavori piani)</translation>
    </message>
    <message>
        <source>Points of a bead closer than {time} ms or {way} are merged if the bead stays the same.</source>
        <translation>I punti di un cordone più vicini di {time} ms o {way} si uniscono se il cordone resta lo stesso.</translation>
    </message>
    <message>
        <source>Power Low limits the speed: Power High is missing</source>
        <translation>Power Low limita la velocità: manca Power High</translation>
    </message>
    <message>
        <source>ROT, but the tool does not turn</source>
        <translation>ROT, ma l&apos;utensile non gira</translation>
    </message>
    <message>
        <source>Program memory of the controller. Longer programs contain a note in their header.</source>
        <translation>Memoria per i programmi del controllore. I programmi più lunghi contengono una nota in testa.</translation>
    </message>
    <message>
        <source>SPEL+ (Epson)</source>
        <translation>SPEL+ (Epson)</translation>
    </message>
    <message>
        <source>ScriptExit() is missing at the end</source>
        <translation>Manca ScriptExit() alla fine</translation>
    </message>
    <message>
        <source>Straight motions accelerate at {acceleration} mm/s2 unless the program states otherwise.</source>
        <translation>I movimenti rettilinei accelerano a {acceleration} mm/s2 se il programma non indica altro.</translation>
    </message>
    <message>
        <source>TMscript (Techman)</source>
        <translation>TMscript (Techman)</translation>
    </message>
    <message>
        <source>The arm stops at points without a blend.</source>
        <translation>Il braccio si ferma nei punti senza raccordo.</translation>
    </message>
    <message>
        <source>Unlimited look-ahead.</source>
        <translation>Anticipo illimitato.</translation>
    </message>
    <message>
        <source>Look-ahead of {motions} motions.</source>
        <translation>Anticipo di {motions} movimenti.</translation>
    </message>
    <message>
        <source>Output delays and following error are not modelled.</source>
        <translation>I ritardi delle uscite e l&apos;errore di inseguimento non sono modellati.</translation>
    </message>
    <message>
        <source>Tool rotation may be limited separately (1 rad = {way:.0f} of path); the slower of the two sets the flow.</source>
        <translation>La rotazione dell&apos;utensile può avere un limite proprio (1 rad = {way:.0f} di percorso); il più lento dei due determina il flusso.</translation>
    </message>
    <message>
        <source>WAIT SEC needs a number of seconds</source>
        <translation>WAIT SEC richiede un numero di secondi</translation>
    </message>
    <message>
        <source>Wait needs a number of seconds</source>
        <translation>Wait richiede un numero di secondi</translation>
    </message>
    <message>
        <source>a G0 under G93 has no defined time</source>
        <translation>un G0 sotto G93 non ha una durata definita</translation>
    </message>
    <message>
        <source>unsupported base: positions must be in the robot&apos;s own base</source>
        <translation>base non supportata: le posizioni devono essere nella base del robot</translation>
    </message>
    <message>
        <source>a base known only to the robot: give its numbers</source>
        <translation>una base nota solo al robot: indicarne i numeri</translation>
    </message>
    <message>
        <source>a blend is no sensible number</source>
        <translation>un raccordo che non è un numero sensato</translation>
    </message>
    <message>
        <source>unsupported call of another program</source>
        <translation>chiamata di un altro programma non supportata</translation>
    </message>
    <message>
        <source>a coordinate is missing, and the arm&apos;s position is not known</source>
        <translation>manca una coordinata, e la posizione del braccio non è nota</translation>
    </message>
    <message>
        <source>the flow is not an integer from 0 to {most}</source>
        <translation>il flusso non è un numero intero da 0 a {most}</translation>
    </message>
    <message>
        <source>the frame&apos;s length differs from the stated one</source>
        <translation>la lunghezza del pacchetto è diversa da quella indicata</translation>
    </message>
    <message>
        <source>the frame is not a script for a listen node</source>
        <translation>il pacchetto non è uno script per un nodo di ascolto</translation>
    </message>
    <message>
        <source>wrong checksum: the frame was modified or truncated</source>
        <translation>somma di controllo sbagliata: il pacchetto è stato modificato o troncato</translation>
    </message>
    <message>
        <source>frame without a length</source>
        <translation>pacchetto senza lunghezza</translation>
    </message>
    <message>
        <source>frame without a name</source>
        <translation>pacchetto senza nome</translation>
    </message>
    <message>
        <source>load without a mass</source>
        <translation>carico senza massa</translation>
    </message>
    <message>
        <source>a mass is no sensible number</source>
        <translation>una massa che non è un numero sensato</translation>
    </message>
    <message>
        <source>another motion between PVTEnter and PVTExit</source>
        <translation>un altro movimento fra PVTEnter e PVTExit</translation>
    </message>
    <message>
        <source>a pure rotation needs ROT</source>
        <translation>una pura rotazione richiede ROT</translation>
    </message>
    <message>
        <source>a motion without F: under G93 each motion needs its own</source>
        <translation>un movimento senza F: sotto G93 ognuno richiede la sua</translation>
    </message>
    <message>
        <source>a motion without G93: its F is not a time</source>
        <translation>un movimento senza G93: la sua F non è un tempo</translation>
    </message>
    <message>
        <source>the numbers of the motion do not match its letters</source>
        <translation>i numeri del movimento non corrispondono alle sue lettere</translation>
    </message>
    <message>
        <source>a pose before ChangeTCP: its TCP is unknown</source>
        <translation>una posa prima di ChangeTCP: il suo TCP non è noto</translation>
    </message>
    <message>
        <source>a position before Tool: its TCP is unknown</source>
        <translation>una posizione prima di Tool: il suo TCP non è noto</translation>
    </message>
    <message>
        <source>step longer than 127 characters</source>
        <translation>passo di più di 127 caratteri</translation>
    </message>
    <message>
        <source>a straight motion before any Spd</source>
        <translation>un movimento rettilineo prima di ogni Spd</translation>
    </message>
    <message>
        <source>a straight motion in percent of an unknown speed</source>
        <translation>un movimento rettilineo in percentuale di una velocità non nota</translation>
    </message>
    <message>
        <source>a straight motion to joints</source>
        <translation>un movimento rettilineo verso valori dei giunti</translation>
    </message>
    <message>
        <source>the target is not a position within a robot&apos;s reach</source>
        <translation>il bersaglio non è una posizione alla portata di un robot</translation>
    </message>
    <message>
        <source>a text has {characters} characters; the controller accepts at most {most}</source>
        <translation>un testo ha {characters} caratteri; il controllore ne accetta al massimo {most}</translation>
    </message>
    <message>
        <source>a tool is a position</source>
        <translation>un utensile è una posizione</translation>
    </message>
    <message>
        <source>a tool known only to the robot: give its numbers</source>
        <translation>un utensile noto solo al robot: indicarne i numeri</translation>
    </message>
    <message>
        <source>a tool, local or control point that only the controller knows</source>
        <translation>un utensile, un riferimento locale o un punto di controllo che solo il controllore conosce</translation>
    </message>
    <message>
        <source>accelerations other than the arm&apos;s own</source>
        <translation>accelerazioni diverse da quelle del braccio</translation>
    </message>
    <message>
        <source>an acceleration is no sensible number</source>
        <translation>un&apos;accelerazione che non è un numero sensato</translation>
    </message>
    <message>
        <source>an analogue output outside 0 to 10 V</source>
        <translation>un&apos;uscita analogica fuori da 0 a 10 V</translation>
    </message>
    <message>
        <source>an angle rotates the long way around</source>
        <translation>un angolo fa il giro lungo</translation>
    </message>
    <message>
        <source>an immediate output, not synchronized with the motions</source>
        <translation>un&apos;uscita immediata, non sincronizzata con i movimenti</translation>
    </message>
    <message>
        <source>an output after CONTINUE runs ahead of the arm</source>
        <translation>un&apos;uscita dopo CONTINUE precede il braccio</translation>
    </message>
    <message>
        <source>an output is 0 or 1</source>
        <translation>un&apos;uscita è 0 o 1</translation>
    </message>
    <message>
        <source>an output of the extruder is set together with other outputs</source>
        <translation>un&apos;uscita dell&apos;estrusore impostata insieme ad altre</translation>
    </message>
    <message>
        <source>axes cannot be the target of a straight motion</source>
        <translation>gli assi non possono essere il bersaglio di un movimento rettilineo</translation>
    </message>
    <message>
        <source>format {format} cannot tilt the nozzle, but this job tilts it by {angle}</source>
        <translation>il formato {format} non può inclinare l&apos;ugello, ma questo lavoro lo inclina di {angle}</translation>
    </message>
    <message>
        <source>how &apos;{word}&apos; rounds a corner is not known to the reader</source>
        <translation>come &apos;{word}&apos; arrotondi uno spigolo non è noto al lettore</translation>
    </message>
    <message>
        <source>joints of a straight motion may be reached in another posture</source>
        <translation>i giunti di un movimento rettilineo si possono raggiungere in un&apos;altra postura</translation>
    </message>
    <message>
        <source>omit it, or give --format {format}</source>
        <translation>ometterla, oppure dare --format {format}</translation>
    </message>
    <message>
        <source>lines end with LF only: a listen node needs CR LF</source>
        <translation>le righe finiscono col solo LF: un nodo di ascolto vuole CR LF</translation>
    </message>
    <message>
        <source>material before X, Y and Z are all known</source>
        <translation>materiale prima che X, Y e Z siano tutti noti</translation>
    </message>
    <message>
        <source>material before X, Y, Z, B and C are all known</source>
        <translation>materiale prima che X, Y, Z, B e C siano tutti noti</translation>
    </message>
    <message>
        <source>must be 1 or -1</source>
        <translation>deve essere 1 o -1</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>deve essere true o false</translation>
    </message>
    <message>
        <source>no {format} motion found: line {line}: {what}</source>
        <translation>nessun movimento {format} trovato: riga {line}: {what}</translation>
    </message>
    <message>
        <source>no procedure is defined</source>
        <translation>nessuna procedura è definita</translation>
    </message>
    <message>
        <source>no program calls this file</source>
        <translation>nessun programma chiama questo file</translation>
    </message>
    <message>
        <source>not all axes are given</source>
        <translation>non tutti gli assi sono dati</translation>
    </message>
    <message>
        <source>invalid plate position relative to the tilt axis</source>
        <translation>posizione del piatto rispetto all&apos;asse di inclinazione non valida</translation>
    </message>
    <message>
        <source>end without a matching beginning</source>
        <translation>fine senza un inizio corrispondente</translation>
    </message>
    <message>
        <source>no procedure of this file is called</source>
        <translation>nessuna procedura di questo file viene richiamata</translation>
    </message>
    <message>
        <source>only triggers at the start of a motion are supported</source>
        <translation>sono supportati solo i trigger all&apos;inizio di un movimento</translation>
    </message>
    <message>
        <source>only the persistent forms of output commands are supported</source>
        <translation>sono ammesse solo le forme permanenti dei comandi di uscita</translation>
    </message>
    <message>
        <source>the work coordinates change: only one nozzle is supported</source>
        <translation>le coordinate di lavoro cambiano: è supportato un solo ugello</translation>
    </message>
    <message>
        <source>part {part}, job {job}, cell {cell} with robot {robot}</source>
        <translation>pezzo {part}, lavoro {job}, cella {cell} con robot {robot}</translation>
    </message>
    <message>
        <source>plate height above the tilt axis</source>
        <translation>altezza del piatto sopra l&apos;asse di inclinazione</translation>
    </message>
    <message>
        <source>plate offset from the tilt axis</source>
        <translation>distanza del piatto dall&apos;asse di inclinazione</translation>
    </message>
    <message>
        <source>speed, acceleration time and blend must be integers</source>
        <translation>velocità, tempo di accelerazione e raccordo devono essere interi</translation>
    </message>
    <message>
        <source>step numbers must ascend, up to 32767</source>
        <translation>i numeri di passo devono crescere, fino a 32767</translation>
    </message>
    <message>
        <source>either the tool&apos;s path or that of the external control point is straight, not both</source>
        <translation>è rettilineo il percorso dell&apos;utensile o quello del punto di controllo esterno, non entrambi</translation>
    </message>
    <message>
        <source>table angles describe</source>
        <translation>gli angoli della tavola descrivono</translation>
    </message>
    <message>
        <source>use {formats}, or a mode with flat layers</source>
        <translation>prendere {formats}, oppure un modo a strati piani</translation>
    </message>
    <message>
        <source>text after a frame</source>
        <translation>testo dopo un pacchetto</translation>
    </message>
    <message>
        <source>the velocity at the last PVT point is not 0</source>
        <translation>la velocità all&apos;ultimo punto di PVT non è 0</translation>
    </message>
    <message>
        <source>the line has {characters} characters; the controller accepts at most {most}</source>
        <translation>la riga ha {characters} caratteri; il controllore ne accetta al massimo {most}</translation>
    </message>
    <message>
        <source>&apos;Type&apos; other than 0,0: the long way around, or independent rotation of the angles</source>
        <translation>&apos;Type&apos; diverso da 0,0: il giro lungo, oppure angoli ruotati in modo indipendente</translation>
    </message>
    <message>
        <source>X or Y motion before B and C are known</source>
        <translation>movimento di X o Y prima che B e C siano noti</translation>
    </message>
    <message>
        <source>the part</source>
        <translation>il pezzo</translation>
    </message>
    <message>
        <source>the procedure has no end</source>
        <translation>la procedura non ha fine</translation>
    </message>
    <message>
        <source>the program has no End</source>
        <translation>il programma non ha End</translation>
    </message>
    <message>
        <source>the program is for another cell: {program}; this job is {job}</source>
        <translation>il programma è per un&apos;altra cella: {program}; questo lavoro è {job}</translation>
    </message>
    <message>
        <source>the program is from another job: {program}; this job is {job}</source>
        <translation>il programma è di un altro lavoro: {program}; questo lavoro è {job}</translation>
    </message>
    <message>
        <source>the called program {name} is missing</source>
        <translation>manca il programma chiamato {name}</translation>
    </message>
    <message>
        <source>table motion before Z is known: the nozzle may be down</source>
        <translation>movimento della tavola prima che Z sia noto: l&apos;ugello potrebbe essere in basso</translation>
    </message>
    <message>
        <source>the tool (ISO 841)</source>
        <translation>l&apos;utensile (ISO 841)</translation>
    </message>
    <message>
        <source>the tool does not turn evenly along its way</source>
        <translation>l&apos;utensile non gira in modo uniforme lungo il percorso</translation>
    </message>
    <message>
        <source>the velocities lead off the path to this point</source>
        <translation>le velocità portano fuori dal percorso verso questo punto</translation>
    </message>
    <message>
        <source>work coordinates that P_WkCord does not set</source>
        <translation>coordinate di lavoro che P_WkCord non imposta</translation>
    </message>
    <message>
        <source>{frame} is not set before this motion</source>
        <translation>{frame} non è impostato prima di questo movimento</translation>
    </message>
    <message>
        <source>{option} applies to {having}, but the chosen formats are {formats}</source>
        <translation>{option} vale per {having}, ma i formati scelti sono {formats}</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is missing</source>
        <translation>manca &apos;{attribute}&apos;</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; must be three numbers: &apos;{text}&apos;</source>
        <translation>&apos;{attribute}&apos; deve essere fatto di tre numeri: &apos;{text}&apos;</translation>
    </message>
    <message>
        <source>expand it first: xacro FILE &gt; arm.urdf</source>
        <translation>espanderlo prima: xacro FILE &gt; arm.urdf</translation>
    </message>
    <message>
        <source>the chain from &apos;{base}&apos; to &apos;{tip}&apos; has {count} turning axes; six are needed</source>
        <translation>la catena da &apos;{base}&apos; a &apos;{tip}&apos; ha {count} assi rotanti; ne servono sei</translation>
    </message>
    <message>
        <source>choose another home pose for the cell; if only the enclosing shapes of two links overlap, list the pair under neverMeet in the robot&apos;s file</source>
        <translation>scegli un&apos;altra posizione di riposo per la cella; se si sovrappongono solo le forme che racchiudono due membri, elenca la coppia sotto neverMeet nel file del robot</translation>
    </message>
    <message>
        <source>has no links</source>
        <translation>non ha membri</translation>
    </message>
    <message>
        <source>has no tip: no joint moves</source>
        <translation>non ha punta: nessun giunto si muove</translation>
    </message>
    <message>
        <source>has several tips: {names}</source>
        <translation>ha più punte: {names}</translation>
    </message>
    <message>
        <source>has two bases, &apos;{first}&apos; and &apos;{second}&apos;: no joint leads from one to the other</source>
        <translation>ha due basi, &apos;{first}&apos; e &apos;{second}&apos;: nessun giunto porta dall&apos;una all&apos;altra</translation>
    </message>
    <message>
        <source>is a xacro file</source>
        <translation>è un file xacro</translation>
    </message>
    <message>
        <source>is not a URDF: it begins with &lt;{element}&gt;</source>
        <translation>non è un URDF: comincia con &lt;{element}&gt;</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; mimics &apos;{other}&apos;: mimic joints are not supported</source>
        <translation>il giunto &apos;{joint}&apos; imita &apos;{other}&apos;: i giunti mimic non sono supportati</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; has an axis of zero length</source>
        <translation>il giunto &apos;{joint}&apos; ha un asse di lunghezza zero</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos;: the lower limit is not below the upper one</source>
        <translation>giunto &apos;{joint}&apos;: il limite inferiore non è sotto il superiore</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; has an unknown type: &apos;{type}&apos;</source>
        <translation>il giunto &apos;{joint}&apos; ha un tipo sconosciuto: &apos;{type}&apos;</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; is {type}; only turning joints are supported</source>
        <translation>il giunto &apos;{joint}&apos; è {type}; sono supportati solo giunti rotanti</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; names an unknown link: &apos;{link}&apos;</source>
        <translation>il giunto &apos;{joint}&apos; nomina un membro sconosciuto: &apos;{link}&apos;</translation>
    </message>
    <message>
        <source>link &apos;{link}&apos; has two parent joints, &apos;{first}&apos; and &apos;{second}&apos;: loops are not supported</source>
        <translation>il membro &apos;{link}&apos; ha due giunti padre, &apos;{first}&apos; e &apos;{second}&apos;: gli anelli non sono supportati</translation>
    </message>
    <message>
        <source>link &apos;{link}&apos; is part of a loop: loops are not supported</source>
        <translation>il membro &apos;{link}&apos; fa parte di un anello: gli anelli non sono supportati</translation>
    </message>
    <message>
        <source>name one: --tip</source>
        <translation>nominarne una: --tip</translation>
    </message>
    <message>
        <source>name the first and last link of the chain: --base, --tip</source>
        <translation>nominare il primo e l&apos;ultimo membro della catena: --base, --tip</translation>
    </message>
    <message>
        <source>the base &apos;{base}&apos; is on a moving branch off the chain to &apos;{tip}&apos;</source>
        <translation>la base &apos;{base}&apos; è su un ramo mobile fuori dalla catena verso &apos;{tip}&apos;</translation>
    </message>
    <message>
        <source>two links are named &apos;{link}&apos;</source>
        <translation>due membri si chiamano &apos;{link}&apos;</translation>
    </message>
    <message>
        <source>{first} collides with {second} in the home pose: no motion is possible</source>
        <translation>{first} urta {second} nella posizione di riposo: nessun movimento è possibile</translation>
    </message>
    <message>
        <source>{option}: no link is named &apos;{name}&apos;</source>
        <translation>{option}: nessun membro si chiama &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>In a PolyScope file node the function must be called after its end. Text sent to port 30001 or 30002 runs by itself and must not call it.</source>
        <translation>In un nodo file di PolyScope la funzione deve essere chiamata dopo la sua fine. Un testo mandato alla porta 30001 o 30002 parte da solo e non deve chiamarla.</translation>
    </message>
    <message>
        <source>a file node</source>
        <translation>un nodo file</translation>
    </message>
    <message>
        <source>a port</source>
        <translation>una porta</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not an extruder command</source>
        <translation>&apos;{text}&apos; non è un comando dell&apos;estrusore</translation>
    </message>
    <message>
        <source>Like an ordinary printer, with the nozzle upright</source>
        <translation>Come una comune stampante, con l&apos;ugello verticale</translation>
    </message>
    <message>
        <source>Filament retracted for each travel, if the extruder can; 0: none.</source>
        <translation>Filamento ritratto a ogni spostamento, se l&apos;estrusore può; 0: nessuno.</translation>
    </message>
    <message>
        <source>Fills the nozzle before the part begins: on the plate, or in the air beside it if there is no room. The material is waste.</source>
        <translation>Riempie l&apos;ugello prima che il pezzo cominci: sul piatto, o in aria accanto se non c&apos;è posto. Il materiale è scarto.</translation>
    </message>
    <message>
        <source>Length of the line beside the part.</source>
        <translation>Lunghezza della linea accanto al pezzo.</translation>
    </message>
    <message>
        <source>Print in flat layers</source>
        <translation>Stampa a strati piani</translation>
    </message>
    <message>
        <source>the filament diameter is out of range</source>
        <translation>il diametro del filamento è fuori dai limiti</translation>
    </message>
    <message>
        <source>a line beside the part</source>
        <translation>una linea accanto al pezzo</translation>
    </message>
    <message>
        <source>a motion is missing or repeated in the filament stream</source>
        <translation>nel flusso di filamento un movimento manca o è ripetuto</translation>
    </message>
    <message>
        <source>a ring around the part</source>
        <translation>un anello attorno al pezzo</translation>
    </message>
    <message>
        <source>a text to be sent is needed</source>
        <translation>serve un testo da inviare</translation>
    </message>
    <message>
        <source>an external axis after an unused one is not supported</source>
        <translation>un asse esterno dopo uno non usato non è supportato</translation>
    </message>
    <message>
        <source>extruder</source>
        <translation>estrusore</translation>
    </message>
    <message>
        <source>retraction</source>
        <translation>ritrazione</translation>
    </message>
    <message>
        <source>the filament position decreases</source>
        <translation>la posizione del filamento diminuisce</translation>
    </message>
    <message>
        <source>format {format} cannot control extruder {extruder} in step with the motion</source>
        <translation>il formato {format} non può comandare l&apos;estrusore {extruder} al passo col movimento</translation>
    </message>
    <message>
        <source>has a name that is already used: &apos;{name}&apos;</source>
        <translation>ha un nome già usato: &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>must have minMm below maxMm</source>
        <translation>deve avere minMm inferiore a maxMm</translation>
    </message>
    <message>
        <source>first-layer bead width</source>
        <translation>larghezza cordone del primo strato</translation>
    </message>
    <message>
        <source>Nominal bead width of the first layer and the brim; limited by the process. 0: that of the process.</source>
        <translation>Larghezza nominale dei cordoni del primo strato e della tesa; limitata dal processo. 0: quella del processo.</translation>
    </message>
    <message>
        <source>outer-wall speed</source>
        <translation>velocità della parete esterna</translation>
    </message>
    <message>
        <source>Speed of the outermost walls. 0: that of the process.</source>
        <translation>Velocità delle pareti più esterne. 0: quella del processo.</translation>
    </message>
    <message>
        <source>inner-wall speed</source>
        <translation>velocità delle pareti interne</translation>
    </message>
    <message>
        <source>Speed of all other walls. 0: that of the process.</source>
        <translation>Velocità di tutte le altre pareti. 0: quella del processo.</translation>
    </message>
    <message>
        <source>infill speed</source>
        <translation>velocità del riempimento</translation>
    </message>
    <message>
        <source>Speed of solid infill and gap fill, limited by the extruder&apos;s flow. 0: that of the process.</source>
        <translation>Velocità del riempimento pieno e dei vuoti, limitata dal flusso dell&apos;estrusore. 0: quella del processo.</translation>
    </message>
    <message>
        <source>support speed</source>
        <translation>velocità dei supporti</translation>
    </message>
    <message>
        <source>Speed of supports. 0: that of the process.</source>
        <translation>Velocità dei supporti. 0: quella del processo.</translation>
    </message>
    <message>
        <source>first-layer speed</source>
        <translation>velocità del primo strato</translation>
    </message>
    <message>
        <source>Speed of all beads of the first layer and of the brim. 0: that of the process.</source>
        <translation>Velocità di tutti i cordoni del primo strato e della tesa. 0: quella del processo.</translation>
    </message>
    <message>
        <source>brim width</source>
        <translation>larghezza della tesa</translation>
    </message>
    <message>
        <source>Width of the loops on the plate around the first layer, which keep it from lifting; break them off after printing. 0: no brim.</source>
        <translation>Larghezza degli anelli sul piano attorno al primo strato, che gli impediscono di sollevarsi; staccarli dopo la stampa. 0: nessuna tesa.</translation>
    </message>
    <message>
        <source>no room on the plate for the whole brim, {width} wide: {share:.0f} of its length is left out</source>
        <translation>nessun posto sul piano per l&apos;intera tesa, larga {width}: {share:.0f} della sua lunghezza è omesso</translation>
    </message>
    <message>
        <source>use a larger plate (`--platform`), move the part to the middle, or set a smaller `brimWidthMm`</source>
        <translation>usare un piano più grande (`--platform`), spostare il pezzo al centro o ridurre `brimWidthMm`</translation>
    </message>
    <message>
        <source>must be between {least} and {most}</source>
        <translation>deve essere tra {least} e {most}</translation>
    </message>
    <message>
        <source>where the travel is shortest</source>
        <translation>dove lo spostamento è più breve</translation>
    </message>
    <message>
        <source>aligned from layer to layer</source>
        <translation>allineata da strato a strato</translation>
    </message>
    <message>
        <source>in a corner</source>
        <translation>in uno spigolo</translation>
    </message>
    <message>
        <source>spread over the part</source>
        <translation>distribuita sul pezzo</translation>
    </message>
    <message>
        <source>unknown seam &apos;{id}&apos;</source>
        <translation>giunzione &apos;{id}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>giunzione</translation>
    </message>
    <message>
        <source>Where closed walls begin and end. A seam aligned or in a corner is less visible; spread seams weaken the part least.</source>
        <translation>Dove iniziano e finiscono le pareti chiuse. Una giunzione allineata o in uno spigolo si vede meno; giunzioni distribuite indeboliscono meno il pezzo.</translation>
    </message>
    <message>
        <source>shortest travel</source>
        <translation>spostamento più breve</translation>
    </message>
    <message>
        <source>as sliced</source>
        <translation>come affettate</translation>
    </message>
    <message>
        <source>order of islands</source>
        <translation>ordine delle isole</translation>
    </message>
    <message>
        <source>Order in which separate islands of a flat layer are printed.</source>
        <translation>Ordine in cui si stampano le isole separate di uno strato piano.</translation>
    </message>
    <message>
        <source>Prints the part as one continuous bead of rising height on its bottom layers: one wall, without infill, top layers and supports under low overhangs.</source>
        <translation>Stampa il pezzo come un unico cordone continuo che sale, sopra i suoi strati inferiori: una parete, senza riempimento, strati superiori e supporti sotto gli sbalzi bassi.</translation>
    </message>
    <message>
        <source>spiral vase</source>
        <translation>vaso a spirale</translation>
    </message>
    <message>
        <source>prime length</source>
        <translation>lunghezza dell&apos;innesco</translation>
    </message>
    <message>
        <source>must be empty: the plate is on the flange</source>
        <translation>deve essere vuoto: il piatto è sulla flangia</translation>
    </message>
    <message>
        <source>too many: robot and external axes together may have {most} axes</source>
        <translation>troppi: robot e assi esterni insieme possono avere {most} assi</translation>
    </message>
    <message>
        <source>must be turning or sliding, is &apos;{kind}&apos;</source>
        <translation>deve essere turning o sliding, è &apos;{kind}&apos;</translation>
    </message>
    <message>
        <source>must not be zero</source>
        <translation>non deve essere nullo</translation>
    </message>
    <message>
        <source>must turn the rod about its own axis, the work frame&apos;s x</source>
        <translation>deve girare l&apos;asta attorno al suo asse, la x del riferimento di lavoro</translation>
    </message>
    <message>
        <source>prime</source>
        <translation>innesco</translation>
    </message>
    <message>
        <source>use extruder {extruders}</source>
        <translation>usa l&apos;estrusore {extruders}</translation>
    </message>
    <message>
        <source>the extruder is switched on or off where that is not possible</source>
        <translation>l&apos;estrusore viene acceso o spento dove non è possibile</translation>
    </message>
    <message>
        <source>the extruder reverses while the nozzle moves</source>
        <translation>l&apos;estrusore va all&apos;indietro mentre l&apos;ugello si muove</translation>
    </message>
    <message>
        <source>the extruder runs where the program does not pause</source>
        <translation>l&apos;estrusore gira dove il programma non fa pausa</translation>
    </message>
    <message>
        <source>the extruder runs where the program has switched it off</source>
        <translation>l&apos;estrusore gira dove il programma lo ha spento</translation>
    </message>
    <message>
        <source>the retracted filament is not returned before the bead</source>
        <translation>il filamento ritratto non è tornato prima del cordone</translation>
    </message>
    <message>
        <source>the file {file} begins with {procedure}: a module must have the name of its first procedure</source>
        <translation>il file {file} comincia con {procedure}: un modulo deve avere il nome della sua prima procedura</translation>
    </message>
    <message>
        <source>the filament stream has no end: the file is truncated</source>
        <translation>il flusso di filamento non ha fine: il file è troncato</translation>
    </message>
    <message>
        <source>the filament stream has no entry for this motion</source>
        <translation>il flusso di filamento non ha voci per questo movimento</translation>
    </message>
    <message>
        <source>this arm keeps the nozzle upright, but the layers need it tilted, first at {place}</source>
        <translation>questo braccio tiene l&apos;ugello verticale, ma gli strati lo richiedono inclinato, dapprima in {place}</translation>
    </message>
    <message>
        <source>time decreases in the filament stream</source>
        <translation>nel flusso di filamento il tempo diminuisce</translation>
    </message>
    <message>
        <source>unknown extruder &apos;{id}&apos;</source>
        <translation>estrusore &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>use mode flat, or planar with upright layers</source>
        <translation>usa la modalità flat, o planar con strati verticali</translation>
    </message>
    <message>
        <source>{joint} at {speed:.1f}/s, above its limit of {limit:.1f#}</source>
        <translation>{joint} a {speed:.1f}/s, oltre il suo limite di {limit:.1f#}</translation>
    </message>
    <message>
        <source>Castelli serial</source>
        <translation>seriale Castelli</translation>
    </message>
    <message>
        <source>E stream</source>
        <translation>flusso E</translation>
    </message>
    <message>
        <source>outputs</source>
        <translation>uscite</translation>
    </message>
    <message>
        <source>the cell&apos;s</source>
        <translation>della cella</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is NaN or out of range: &apos;{text}&apos;</source>
        <translation>&apos;{attribute}&apos; non è un numero o è fuori scala: &apos;{text}&apos;</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is a built-in cell</source>
        <translation>&apos;{id}&apos; è una cella del programma</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is not a valid cell name</source>
        <translation>&apos;{id}&apos; non è un nome di cella valido</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not a number</source>
        <translation>&apos;{word}&apos; non è un numero</translation>
    </message>
    <message>
        <source>How rotations about the nozzle are smoothed: quickly, or by a search for minimum joint jerk, which doubles the planning time of the motion.</source>
        <translation>Come si rendono regolari le rotazioni attorno all&apos;ugello: in fretta, o cercando il minimo strappo dei giunti, che raddoppia il tempo di pianificazione del moto.</translation>
    </message>
    <message>
        <source>Reached poses</source>
        <translation>Pose raggiunte</translation>
    </message>
    <message>
        <source>a frame needs at least three points</source>
        <translation>un riferimento richiede almeno tre punti</translation>
    </message>
    <message>
        <source>a measured number is not finite</source>
        <translation>un numero misurato non è finito</translation>
    </message>
    <message>
        <source>a quaternion&apos;s length is {length:.4g}, not 1</source>
        <translation>la lunghezza di un quaternione è {length:.4g}, non 1</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is the name of a built-in robot</source>
        <translation>&apos;{id}&apos; è il nome di un robot già incluso</translation>
    </message>
    <message>
        <source>a row contains the robot&apos;s joints</source>
        <translation>una riga contiene i giunti del robot</translation>
    </message>
    <message>
        <source>a row contains x,y,z,qw,qx,qy,qz; for joints name the robot</source>
        <translation>una riga contiene x,y,z,qw,qx,qy,qz; per i giunti indica il robot</translation>
    </message>
    <message>
        <source>a tool tip needs at least four poses</source>
        <translation>la punta di un utensile richiede almeno quattro pose</translation>
    </message>
    <message>
        <source>in the home pose {first} collides with {second}</source>
        <translation>in posizione di riposo {first} urta {second}</translation>
    </message>
    <message>
        <source>bring plate and nozzle nearer to the arm</source>
        <translation>avvicina piatto e ugello al braccio</translation>
    </message>
    <message>
        <source>cannot be read: not a mesh, or damaged</source>
        <translation>illeggibile: non è una mesh, o è danneggiata</translation>
    </message>
    <message>
        <source>cannot be read: voluta-mesh-reader is missing beside this program</source>
        <translation>illeggibile: accanto a questo programma manca voluta-mesh-reader</translation>
    </message>
    <message>
        <source>cell {cell} has no plate to map</source>
        <translation>la cella {cell} non ha un piatto</translation>
    </message>
    <message>
        <source>smoothed</source>
        <translation>livellate</translation>
    </message>
    <message>
        <source>give the arm another name: --id</source>
        <translation>dai un altro nome al braccio: --id</translation>
    </message>
    <message>
        <source>give three rows x,y,z (origin, point on x, point in the xy plane), or at least three rows of six: nominal point in the frame, touched point</source>
        <translation>dai tre righe x,y,z (origine, punto su x, punto nel piano xy), o almeno tre righe di sei: punto nominale nel riferimento, punto toccato</translation>
    </message>
    <message>
        <source>is damaged: the reader failed</source>
        <translation>è danneggiato: il lettore non è riuscito</translation>
    </message>
    <message>
        <source>minimum jerk of whole paths</source>
        <translation>minimo strappo di percorsi interi</translation>
    </message>
    <message>
        <source>jerk of joint {joint} at its greatest here: {jerk:.3g} rad/s³, limit {limit:.3g} rad/s³</source>
        <translation>qui lo strappo del giunto {joint} è massimo: {jerk:.3g} rad/s³, limite {limit:.3g} rad/s³</translation>
    </message>
    <message>
        <source>smooth whole paths (`rotationSmoothing=wholePath`), print slower, or allow more jerk (`maxJerk`)</source>
        <translation>rendi regolari i percorsi interi (`rotationSmoothing=wholePath`), stampa più lentamente o ammetti più strappo (`maxJerk`)</translation>
    </message>
    <message>
        <source>maximum jerk</source>
        <translation>strappo massimo</translation>
    </message>
    <message>
        <source>Maximum jerk of every joint; for a sliding joint 100 mm count as 1 rad. The robot moves more slowly where a joint would exceed it, and speeds up and slows down more gently. 0: no limit.</source>
        <translation>Strappo massimo di ogni giunto; per un giunto traslante 100 mm valgono 1 rad. Il robot si muove più lentamente dove un giunto lo supererebbe, e accelera e frena più dolcemente. 0: nessun limite.</translation>
    </message>
    <message>
        <source>shapes</source>
        <translation>forme</translation>
    </message>
    <message>
        <source>shapes, and a learned indicator</source>
        <translation>forme, e un indicatore appreso</translation>
    </message>
    <message>
        <source>collision model</source>
        <translation>modello di collisione</translation>
    </message>
    <message>
        <source>How a search for minimum joint jerk of whole paths avoids collisions: by checks of the shapes afterwards, or also by the gradient of an indicator that is learned for each layer (for research; slow). The shapes decide in both cases.</source>
        <translation>Come la ricerca del minimo strappo dei giunti su percorsi interi evita le collisioni: controllando poi le forme, o anche con il gradiente di un indicatore appreso per ogni strato (per ricerca; lento). In entrambi i casi decidono le forme.</translation>
    </message>
    <message>
        <source>with the nozzle lifted</source>
        <translation>con l&apos;ugello sollevato</translation>
    </message>
    <message>
        <source>while printing, if possible</source>
        <translation>durante la stampa, se possibile</translation>
    </message>
    <message>
        <source>change of the arm&apos;s branch</source>
        <translation>cambio di configurazione del braccio</translation>
    </message>
    <message>
        <source>Where the arm cannot print a whole path in one branch: whether the path is interrupted there, or the wrist changes over several points while printing, with the nozzle tilted within the tilt tolerance.</source>
        <translation>Dove il braccio non può stampare un percorso intero in una sola configurazione: se il percorso vi si interrompe, o se il polso cambia lungo più punti durante la stampa, con l&apos;ugello inclinato entro la tolleranza.</translation>
    </message>
    <message>
        <source>remove the row, or measure it again</source>
        <translation>togli la riga o rimisurala</translation>
    </message>
    <message>
        <source>lengths in a URDF are metres</source>
        <translation>in un URDF le lunghezze sono in metri</translation>
    </message>
    <message>
        <source>check the limits and solids in the description, or name its links: --base, --tip</source>
        <translation>controlla limiti e solidi nella descrizione, o indica i link: --base, --tip</translation>
    </message>
    <message>
        <source>reduce the payload, or use a stronger robot</source>
        <translation>riduci il carico, o usa un robot più forte</translation>
    </message>
    <message>
        <source>measure another point</source>
        <translation>misura un altro punto</translation>
    </message>
    <message>
        <source>measure another pose</source>
        <translation>misura un&apos;altra posa</translation>
    </message>
    <message>
        <source>measure three points</source>
        <translation>misura tre punti</translation>
    </message>
    <message>
        <source>move one of them, or choose another home pose</source>
        <translation>sposta uno dei due, o cambia la posa di riposo</translation>
    </message>
    <message>
        <source>move one of them, or make the stem or the nozzle longer</source>
        <translation>sposta uno dei due, o allunga lo stelo o l&apos;ugello</translation>
    </message>
    <message>
        <source>move the nozzle&apos;s frame</source>
        <translation>sposta il riferimento dell&apos;ugello</translation>
    </message>
    <message>
        <source>no folder for user-defined cells</source>
        <translation>nessuna cartella per le celle proprie</translation>
    </message>
    <message>
        <source>not a table of points</source>
        <translation>non è una tabella di punti</translation>
    </message>
    <message>
        <source>searching a place for the plate</source>
        <translation>ricerca di un posto per il piatto</translation>
    </message>
    <message>
        <source>poses {first} and {second} are identical</source>
        <translation>le pose {first} e {second} sono uguali</translation>
    </message>
    <message>
        <source>set HOME, or VOLUTA_DATA to a folder</source>
        <translation>imposta HOME, o VOLUTA_DATA su una cartella</translation>
    </message>
    <message>
        <source>smoothing of rotations</source>
        <translation>rotazioni regolari</translation>
    </message>
    <message>
        <source>use a cell with a plate</source>
        <translation>usa una cella con un piatto</translation>
    </message>
    <message>
        <source>measure a point well off the line through the others</source>
        <translation>misura un punto ben fuori dalla retta per gli altri</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>scegli un altro nome</translation>
    </message>
    <message>
        <source>takes too long to read</source>
        <translation>la lettura dura troppo</translation>
    </message>
    <message>
        <source>no place found where the arm reaches above a plate without collision (reach {reach} mm)</source>
        <translation>nessun posto trovato in cui il braccio arrivi sopra un piatto senza urti (sbraccio {reach} mm)</translation>
    </message>
    <message>
        <source>implausible reach of the arm: {reach} mm</source>
        <translation>sbraccio non plausibile: {reach} mm</translation>
    </message>
    <message>
        <source>the arm&apos;s description</source>
        <translation>la descrizione del braccio</translation>
    </message>
    <message>
        <source>payload {carried:.3g} kg exceeds the robot&apos;s rating of {most:.3g} kg</source>
        <translation>il carico di {carried:.3g} kg supera la portata del robot, {most:.3g} kg</translation>
    </message>
    <message>
        <source>must be larger than that of the point before</source>
        <translation>deve essere maggiore di quello del punto precedente</translation>
    </message>
    <message>
        <source>must not be larger than that of the point before</source>
        <translation>non deve essere maggiore di quella del punto precedente</translation>
    </message>
    <message>
        <source>must have at least one point</source>
        <translation>deve avere almeno un punto</translation>
    </message>
    <message>
        <source>fixed nozzle</source>
        <translation>ugello fisso</translation>
    </message>
    <message>
        <source>tilting table</source>
        <translation>tavola basculante</translation>
    </message>
    <message>
        <source>raised plate</source>
        <translation>piatto rialzato</translation>
    </message>
    <message>
        <source>table on the floor</source>
        <translation>tavola a terra</translation>
    </message>
    <message>
        <source>it prints around a rod</source>
        <translation>stampa attorno a una barra</translation>
    </message>
    <message>
        <source>its largest plate is too small for the foot, which fits at scale {scale}</source>
        <translation>il suo piatto più grande è troppo piccolo per la base, che ci sta alla scala {scale}</translation>
    </message>
    <message>
        <source>its flange would carry {kg:.3g} kg at {lever:.0f}, the robot carries {most:.3g} kg there</source>
        <translation>la flangia porterebbe {kg:.3g} kg a {lever:.0f}, dove il robot porta {most:.3g} kg</translation>
    </message>
    <message>
        <source>its flange would carry {kg:.3g} kg, the robot&apos;s rating is {most:.3g} kg</source>
        <translation>la flangia porterebbe {kg:.3g} kg, la portata del robot è di {most:.3g} kg</translation>
    </message>
    <message>
        <source>its nozzle cannot tilt</source>
        <translation>il suo ugello non può inclinarsi</translation>
    </message>
    <message>
        <source>its head is too bulky to lean</source>
        <translation>la sua testa è troppo ingombrante per inclinarsi</translation>
    </message>
    <message>
        <source>its nozzle reaches {share:.0f} of the part upright</source>
        <translation>il suo ugello raggiunge in verticale il {share:.0f} del pezzo</translation>
    </message>
    <message>
        <source>its nozzle reaches {share:.0f} of the poses up to a tilt of {tilt:.0f}</source>
        <translation>il suo ugello raggiunge il {share:.0f} delle pose fino a un&apos;inclinazione di {tilt:.0f}</translation>
    </message>
    <message>
        <source>no cell with a fixed nozzle is among them</source>
        <translation>tra queste non c&apos;è una cella con ugello fisso</translation>
    </message>
    <message>
        <source>{cell} is out: {reason}</source>
        <translation>{cell} è esclusa: {reason}</translation>
    </message>
    <message>
        <source>{cell}: its fixed nozzle stays upright, so gravity helps; the platform may be small, and the arm carries plate and part ({kg:.3g} kg)</source>
        <translation>{cell}: l&apos;ugello fisso resta verticale, quindi la gravità aiuta; la piattaforma può essere piccola e il braccio porta piatto e pezzo ({kg:.3g} kg)</translation>
    </message>
    <message>
        <source>{cell}: its table tilts the part, so gravity helps; {fixed}</source>
        <translation>{cell}: la tavola inclina il pezzo, quindi la gravità aiuta; {fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves and takes large parts, and the raised plate stays small for a leaning head, but gravity does not help at up to {lean:.0f} from vertical; {fixed}</source>
        <translation>{cell}: l&apos;ugello si muove e permette pezzi grandi, e il piatto rialzato resta piccolo per una testa inclinata, ma la gravità non aiuta fino a {lean:.0f} dalla verticale; {fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves, always upright, and takes large parts; {fixed}</source>
        <translation>{cell}: l&apos;ugello si muove, sempre verticale, e permette pezzi grandi; {fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves over a table on the floor and takes large parts, but the platform is not small and gravity does not help at up to {lean:.0f} from vertical; {fixed}</source>
        <translation>{cell}: l&apos;ugello si muove sopra una tavola a terra e permette pezzi grandi, ma la piattaforma non è piccola e la gravità non aiuta fino a {lean:.0f} dalla verticale; {fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves, always upright, over a table on the floor and takes large parts; {fixed}</source>
        <translation>{cell}: l&apos;ugello si muove, sempre verticale, sopra una tavola a terra e permette pezzi grandi; {fixed}</translation>
    </message>
    <message>
        <source>none of these cells: {reasons}</source>
        <translation>nessuna di queste celle: {reasons}</translation>
    </message>
    <message>
        <source>the nozzle is inside {body}</source>
        <translation>l&apos;ugello è dentro {body}</translation>
    </message>
    <message>
        <source>the plate is out of the arm&apos;s reach</source>
        <translation>il piatto è fuori dalla portata del braccio</translation>
    </message>
    <message>
        <source>the points are on a line: the frame&apos;s rotation about it is undefined</source>
        <translation>i punti stanno su una retta: la rotazione del riferimento attorno ad essa è indefinita</translation>
    </message>
    <message>
        <source>the poses rotate the flange about one axis only, or hardly at all</source>
        <translation>le pose ruotano la flangia attorno a un solo asse, o quasi per nulla</translation>
    </message>
    <message>
        <source>tilt it by at least 30 degrees about two axes</source>
        <translation>inclinala di almeno 30 gradi attorno a due assi</translation>
    </message>
    <message>
        <source>rotate the flange between poses</source>
        <translation>ruota la flangia tra le pose</translation>
    </message>
    <message>
        <source>two of the three points are identical</source>
        <translation>due dei tre punti sono uguali</translation>
    </message>
    <message>
        <source>use letters, digits, dashes and dots</source>
        <translation>usa lettere, cifre, trattini e punti</translation>
    </message>
    <message>
        <source>reach of the head</source>
        <translation>portata della testa</translation>
    </message>
    <message>
        <source>wherever the nozzle reaches the plate, {first} collides with {second}</source>
        <translation>ovunque l&apos;ugello arrivi al piatto, {first} urta {second}</translation>
    </message>
    <message>
        <source>{found} numbers in a row instead of {wanted}</source>
        <translation>{found} numeri in una riga invece di {wanted}</translation>
    </message>
    <message>
        <source>{found} numbers in a row instead of {wanted} as in the first</source>
        <translation>{found} numeri in una riga invece di {wanted} come nella prima</translation>
    </message>
    <message>
        <source>CR750 (7.11 ms)</source>
        <translation>CR750 (7,11 ms)</translation>
    </message>
    <message>
        <source>CR800 (3.5 ms)</source>
        <translation>CR800 (3,5 ms)</translation>
    </message>
    <message>
        <source>Events set the analogue output where a motion begins (TriggEquip); by TCP speed, it follows the TCP&apos;s actual speed, so that slow corners get no excess (TriggSpeed).</source>
        <translation>Gli eventi impostano l&apos;uscita analogica dove inizia un moto (TriggEquip); per velocità essa segue la velocità reale del TCP, così gli angoli lenti non ricevono di più (TriggSpeed).</translation>
    </message>
    <message>
        <source>How far the nozzle may tilt from its planned direction where that makes the joints&apos; motion smoother. Only with minimum jerk of whole paths.</source>
        <translation>Di quanto l&apos;ugello può inclinarsi dalla direzione prevista dove ciò rende più regolare il moto dei giunti. Solo con minimo strappo di percorsi interi.</translation>
    </message>
    <message>
        <source>Rotation of the nozzle about its own axis: best for the arm, or by a rule if the nozzle&apos;s attachments have a front. With a rule, fewer points can be reached.</source>
        <translation>Rotazione dell&apos;ugello attorno al proprio asse: come conviene al braccio, o secondo una regola, se ciò che è montato sull&apos;ugello ha un davanti. Con una regola si raggiungono meno punti.</translation>
    </message>
    <message>
        <source>Joint stream (MELFA Mxt, with packets and sender)</source>
        <translation>Flusso di giunti (MELFA Mxt, con pacchetti e mittente)</translation>
    </message>
    <message>
        <source>Joint stream (Universal Robots, with receiver and sender)</source>
        <translation>Flusso di giunti (Universal Robots, con ricevente e mittente)</translation>
    </message>
    <message>
        <source>MELFA stream: one packet is sent per controller cycle.</source>
        <translation>Flusso MELFA: a ogni ciclo del controllore si invia un pacchetto.</translation>
    </message>
    <message>
        <source>RAPID: flow controlled by</source>
        <translation>RAPID: flusso comandato da</translation>
    </message>
    <message>
        <source>an invalid flow per speed</source>
        <translation>un flusso per velocità non valido</translation>
    </message>
    <message>
        <source>a second stream</source>
        <translation>un secondo flusso</translation>
    </message>
    <message>
        <source>a stream has exactly one motion to the start, as its first row</source>
        <translation>un flusso ha un solo movimento verso l&apos;inizio, nella prima riga</translation>
    </message>
    <message>
        <source>a stream of {count} packets is too large for a file</source>
        <translation>un flusso di {count} pacchetti è troppo grande per un file</translation>
    </message>
    <message>
        <source>along the path</source>
        <translation>lungo il percorso</translation>
    </message>
    <message>
        <source>along the plate</source>
        <translation>lungo il piatto</translation>
    </message>
    <message>
        <source>best for the arm</source>
        <translation>come conviene al braccio</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>controllore</translation>
    </message>
    <message>
        <source>tilt tolerance</source>
        <translation>tolleranza d&apos;inclinazione</translation>
    </message>
    <message>
        <source>events at points</source>
        <translation>eventi nei punti</translation>
    </message>
    <message>
        <source>format {format} states joint values for another maker&apos;s arm, not for the {robot} of cell {cell}</source>
        <translation>il formato {format} indica i giunti del braccio di un altro costruttore, non del {robot} della cella {cell}</translation>
    </message>
    <message>
        <source>smallest rotation from upright</source>
        <translation>minima rotazione dalla verticale</translation>
    </message>
    <message>
        <source>not the header of a joint stream</source>
        <translation>non è l&apos;intestazione di un flusso di giunti</translation>
    </message>
    <message>
        <source>not the program that receives this stream: &apos;{code}&apos;</source>
        <translation>non è il programma che riceve questo flusso: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>packet {number} does not match the rows</source>
        <translation>il pacchetto {number} non corrisponde alle righe</translation>
    </message>
    <message>
        <source>use melfa</source>
        <translation>usa melfa</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>velocità del TCP</translation>
    </message>
    <message>
        <source>the arm waits at another target than the previous one</source>
        <translation>il braccio attende in un bersaglio diverso dal precedente</translation>
    </message>
    <message>
        <source>the extruder&apos;s outputs are not off at the end</source>
        <translation>alla fine le uscite dell&apos;estrusore non sono spente</translation>
    </message>
    <message>
        <source>a flow proportional to the speed in a motion of unknown length</source>
        <translation>un flusso proporzionale alla velocità in un movimento di lunghezza ignota</translation>
    </message>
    <message>
        <source>the program that receives the stream is truncated</source>
        <translation>il programma che riceve il flusso è troncato</translation>
    </message>
    <message>
        <source>the row that ends the stream is missing: the file is truncated</source>
        <translation>manca la riga che chiude il flusso: il file è troncato</translation>
    </message>
    <message>
        <source>this is not the program that receives a stream</source>
        <translation>non è il programma che riceve un flusso</translation>
    </message>
    <message>
        <source>this line differs from the one Voluta writes; it is the same for every job</source>
        <translation>questa riga è diversa da quella che scrive Voluta; è uguale per ogni lavoro</translation>
    </message>
    <message>
        <source>nozzle rotation</source>
        <translation>rotazione dell&apos;ugello</translation>
    </message>
    <message>
        <source>Maximum filament length that the external axis feeds before it is reset to 0.</source>
        <translation>Lunghezza massima di filamento spinta dall&apos;asse esterno prima di essere riportato a 0.</translation>
    </message>
    <message>
        <source>How far the nozzle moves back over its bead, or on along a closed one, with the extruder off before it lifts. 0: it lifts at the end of the bead.</source>
        <translation>Di quanto l&apos;ugello torna sul suo cordone, o prosegue lungo uno che si chiude, a estrusore spento, prima di sollevarsi per il prossimo. 0: si solleva dove il cordone finisce.</translation>
    </message>
    <message>
        <source>How the program controls the extruder. Outputs: one for on/off, one for the flow. Castelli serial: texts over a socket. E stream: a file of amounts over time. External axis: mm of filament in each motion.</source>
        <translation>Come il programma comanda l&apos;estrusore. Uscite: una acceso/spento, una per il flusso. Seriale Castelli: testi su un socket. Flusso E: un file di quantità nel tempo. Asse esterno: mm di filamento in ogni moto.</translation>
    </message>
    <message>
        <source>the whole mesh is a single point</source>
        <translation>tutta la mesh è un solo punto</translation>
    </message>
    <message>
        <source>at {x:.3f#}, {y:.3f#}, {z:.3f}, rotated by {rx:.3f#}, {ry:.3f#}, {rz:.3f}</source>
        <translation>in {x:.3f#}, {y:.3f#}, {z:.3f}, ruotato di {rx:.3f#}, {ry:.3f#}, {rz:.3f}</translation>
    </message>
    <message>
        <source>more than {length:.0f} of filament is needed between two lifts: beyond the extruder axis&apos; range</source>
        <translation>tra due sollevamenti servono più di {length:.0f} di filamento: oltre la corsa dell&apos;asse dell&apos;estrusore</translation>
    </message>
    <message>
        <source>external axes that move alone are only supported for the extruder, with a time</source>
        <translation>gli assi esterni che si muovono da soli sono supportati solo per l&apos;estrusore, con un tempo</translation>
    </message>
    <message>
        <source>external axis</source>
        <translation>asse esterno</translation>
    </message>
    <message>
        <source>extruder axis: range</source>
        <translation>asse dell&apos;estrusore: corsa</translation>
    </message>
    <message>
        <source>no redundant measurements: the error cannot be estimated</source>
        <translation>nessuna misura ridondante: l&apos;errore non si può stimare</translation>
    </message>
    <message>
        <source>increase {option}</source>
        <translation>usa un valore maggiore di {option}</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is missing</source>
        <translation>manca l&apos;asse dell&apos;estrusore</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is not set to 0 before this motion</source>
        <translation>l&apos;asse dell&apos;estrusore non è portato a 0 prima di questo moto</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is slowed: the arm would wait for it</source>
        <translation>l&apos;asse dell&apos;estrusore è rallentato: il braccio lo aspetterebbe</translation>
    </message>
    <message>
        <source>wipe</source>
        <translation>pulizia</translation>
    </message>
    <message>
        <source>{rows} rows, residual {rms:.3f} on average and {worst:.3f} at most: accurate to {place:.3f}</source>
        <translation>{rows} righe, scarto medio {rms:.3f} e massimo {worst:.3f}: preciso entro {place:.3f}</translation>
    </message>
    <message>
        <source>{rows} rows, residual {rms:.3f} on average and {worst:.3f} at most: accurate to {place:.3f} and {turn:.3f}</source>
        <translation>{rows} righe, scarto medio {rms:.3f} e massimo {worst:.3f}: preciso entro {place:.3f} e {turn:.3f}</translation>
    </message>
    <message>
        <source>Extended G-code: also writes a RAPID module that reads the file on an ABB controller and runs arm and extruder.</source>
        <translation>G-code esteso: scrive anche un modulo RAPID che legge il file su un controllore ABB e muove braccio ed estrusore.</translation>
    </message>
    <message>
        <source>Lines by data link (MELFA-BASIC V, with receiver and sender)</source>
        <translation>Righe via data link (MELFA-BASIC V, con ricevitore e mittente)</translation>
    </message>
    <message>
        <source>a RAPID module (ABB)</source>
        <translation>un modulo RAPID (ABB)</translation>
    </message>
    <message>
        <source>a module that reads G-code cannot move the {axis} of cell {cell}: G-code does not state its position</source>
        <translation>un modulo che legge G-code non può muovere {axis} della cella {cell}: il G-code non ne indica la posizione</translation>
    </message>
    <message>
        <source>a position before the tool is defined</source>
        <translation>una posizione prima che l&apos;utensile sia definito</translation>
    </message>
    <message>
        <source>the full flow is not the process&apos;s</source>
        <translation>il flusso pieno non è quello del processo</translation>
    </message>
    <message>
        <source>companion reader for extended G-code</source>
        <translation>lettore associato al G-code esteso</translation>
    </message>
    <message>
        <source>its count (G92 C)</source>
        <translation>il suo conto (G92 C)</translation>
    </message>
    <message>
        <source>joint motions with joint targets and with pose targets in one stream</source>
        <translation>movimenti dei giunti con bersagli in giunti e in pose in un solo flusso</translation>
    </message>
    <message>
        <source>not the header of lines for a data link</source>
        <translation>non è l&apos;intestazione di righe per un data link</translation>
    </message>
    <message>
        <source>unexpected in the program that receives these lines: &apos;{code}&apos;</source>
        <translation>inatteso nel programma che riceve queste righe: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>niente</translation>
    </message>
    <message>
        <source>set `tableTurns` to {turns} or more</source>
        <translation>imposta `tableTurns` a {turns} o più</translation>
    </message>
    <message>
        <source>choose rapid</source>
        <translation>usa rapid</translation>
    </message>
    <message>
        <source>the arm does not stop before this line</source>
        <translation>il braccio non si ferma prima di questa riga</translation>
    </message>
    <message>
        <source>the extruder is on in a joint motion</source>
        <translation>l&apos;estrusore è acceso in un movimento dei giunti</translation>
    </message>
    <message>
        <source>the job&apos;s file, start or full flow is missing or given twice</source>
        <translation>il file, l&apos;inizio o il flusso pieno del lavoro manca o c&apos;è due volte</translation>
    </message>
    <message>
        <source>the first line is not a joint motion to the start</source>
        <translation>la prima riga non è un movimento dei giunti verso l&apos;inizio</translation>
    </message>
    <message>
        <source>layer &apos;{path}&apos; has no height above the previous one</source>
        <translation>lo strato &apos;{path}&apos; non ha altezza sopra quello precedente</translation>
    </message>
    <message>
        <source>the line that ends the stream is missing: the file is truncated</source>
        <translation>manca la riga che chiude il flusso: il file è stato troncato</translation>
    </message>
    <message>
        <source>the program that receives the lines is truncated</source>
        <translation>il programma che riceve le righe è troncato</translation>
    </message>
    <message>
        <source>the table</source>
        <translation>la tavola</translation>
    </message>
    <message>
        <source>within a bead the table would turn by more than {turns} turns to one side</source>
        <translation>entro un cordone la tavola girerebbe oltre {turns} giri da un lato</translation>
    </message>
    <message>
        <source>this is not the module that reads G-code</source>
        <translation>questo non è il modulo che legge il G-code</translation>
    </message>
    <message>
        <source>tool-paths of type &apos;{type}&apos; without beads; only beads from a nozzle are supported</source>
        <translation>percorsi di tipo &apos;{type}&apos; senza cordoni; sono supportati solo cordoni di un ugello</translation>
    </message>
    <message>
        <source>turns until C is reset</source>
        <translation>giri prima che C torni indietro</translation>
    </message>
    <message>
        <source>reset of C</source>
        <translation>ritorno di C</translation>
    </message>
    <message>
        <source>Adds break-away beads under low overhangs; thickens the overhanging bead instead where that is enough.</source>
        <translation>Aggiunge cordoni staccabili sotto gli sbalzi bassi; dove basta, ispessisce invece il cordone a sbalzo.</translation>
    </message>
    <message>
        <source>Lines by EthernetKRL (KUKA, with receiver and sender)</source>
        <translation>Righe via EthernetKRL (KUKA, con ricevitore e mittente)</translation>
    </message>
    <message>
        <source>an axis that carries the robot is missing</source>
        <translation>manca un asse che porta il robot</translation>
    </message>
    <message numerus="yes">
        <source>support beads ({volume:.3g}) under {paths} beads that would overhang just above the plate or the printed part</source>
        <translation>
            <numerusform>cordoni di supporto ({volume:.3g}) sotto {paths} cordone che sporgerebbe appena sopra il piatto o il pezzo stampato</numerusform>
            <numerusform>cordoni di supporto ({volume:.3g}) sotto {paths} cordoni che sporgerebbero appena sopra il piatto o il pezzo stampato</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{paths} unsupported beads are printed after their inner neighbours, with the nozzle tilted by up to {lean:.0f} more</source>
        <translation>
            <numerusform>{paths} cordone non sostenuto è stampato dopo il vicino più interno, con l&apos;ugello inclinato fino a {lean:.0f} in più</numerusform>
            <numerusform>{paths} cordoni non sostenuti sono stampati dopo i vicini più interni, con l&apos;ugello inclinato fino a {lean:.0f} in più</numerusform>
        </translation>
    </message>
    <message>
        <source>if you do not want this, turn the part or print it in flat layers with supports</source>
        <translation>se non lo si vuole, girare il pezzo o stamparlo a strati piani con supporti</translation>
    </message>
    <message>
        <source>format {format} does not support external axes: it cannot move the {axis} of cell {cell}</source>
        <translation>il formato {format} non supporta assi esterni: non può muovere {axis} della cella {cell}</translation>
    </message>
    <message>
        <source>must be platform after an axis that carries the platform</source>
        <translation>deve essere platform dopo un asse che porta la piattaforma</translation>
    </message>
    <message>
        <source>must be platform or robot, is &apos;{carries}&apos;</source>
        <translation>deve essere platform o robot, è &apos;{carries}&apos;</translation>
    </message>
    <message>
        <source>either a base or a fixed nozzle has to be defined</source>
        <translation>va definita una base oppure un ugello fisso</translation>
    </message>
    <message>
        <source>support low overhangs</source>
        <translation>supporto per sbalzi bassi</translation>
    </message>
    <message>
        <source>the program&apos;s nozzle is {distance:.2f} and {angle:.2f} off the cell&apos;s nozzle</source>
        <translation>l&apos;ugello del programma è a {distance:.2f} e {angle:.2f} da quello della cella</translation>
    </message>
    <message numerus="yes">
        <source>{waypoints} waypoints ({share:.2g} of the material) are skipped; see the findings above</source>
        <translation>
            <numerusform>{waypoints} punto del percorso ({share:.2g} del materiale) viene tralasciato; vedi le segnalazioni precedenti</numerusform>
            <numerusform>{waypoints} punti del percorso ({share:.2g} del materiale) vengono tralasciati; vedi le segnalazioni precedenti</numerusform>
        </translation>
    </message>
    <message>
        <source>The largest scale that the robot reaches entirely</source>
        <translation>La scala massima che il robot raggiunge per intero</translation>
    </message>
    <message>
        <source>print it at scale {scale:.3g}, turn it, or use a larger robot</source>
        <translation>stampalo in scala {scale:.3g}, giralo o usa un robot più grande</translation>
    </message>
    <message>
        <source>use flat layers, which need no tilt of the nozzle, turn the part, or use a larger robot</source>
        <translation>usa strati piani, in cui l&apos;ugello non deve inclinarsi, gira il pezzo o usa un robot più grande</translation>
    </message>
    <message>
        <source>{share:.2g} of the tool-path points are out of the robot&apos;s reach</source>
        <translation>{share:.2g} dei punti dei percorsi è fuori dalla portata del robot</translation>
    </message>
    <message>
        <source>{share:.2g} of the tool-path points are out of the robot&apos;s reach; at {size:.2g} of this size all would be reachable</source>
        <translation>{share:.2g} dei punti dei percorsi è fuori dalla portata del robot; al {size:.2g} di questa dimensione sarebbero tutti raggiungibili</translation>
    </message>
    <message>
        <source>Let Voluta choose</source>
        <translation>Lascia scegliere Voluta</translation>
    </message>
    <message>
        <source>Tries the ways of building in turn until nothing is unsupported or missed</source>
        <translation>Prova i modi di costruire uno dopo l&apos;altro, finché nulla è senza appoggio o manca</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is a reserved word and cannot name a function</source>
        <translation>&apos;{name}&apos; è una parola riservata e non può dare il nome a una funzione</translation>
    </message>
    <message>
        <source>ambiguous number &apos;{number}&apos;: decimal comma or thousands separator</source>
        <translation>numero ambiguo &apos;{number}&apos;: virgola decimale o separatore delle migliaia</translation>
    </message>
    <message>
        <source>20 % smaller</source>
        <translation>20 % più piccolo</translation>
    </message>
    <message>
        <source>Adds a verification report to each program, NAME.proof.html and NAME.proof.pdf: the verdict, the checks and the margins to the limits; its figures as NAME.proof.json; and NAME.printed.stl, the part as printed, as a solid.</source>
        <translation>Aggiunge a ogni programma un rapporto di verifica, NOME.proof.html e NOME.proof.pdf: l&apos;esito, le verifiche e i margini dai limiti; i valori in NOME.proof.json; e NOME.printed.stl, il pezzo stampato come solido.</translation>
    </message>
    <message>
        <source>Allow less clearance</source>
        <translation>Ammetti meno distanza</translation>
    </message>
    <message>
        <source>Amount: {share:.1f} of the part&apos;s volume is deposited; {least:.4g#} to {most:.4g} allowed.</source>
        <translation>Quantità: si depone il {share:.1f} del volume del pezzo; ammesso da {least:.4g#} a {most:.4g}.</translation>
    </message>
    <message>
        <source>Arm, joints and their limits: not checked, as the program contains nozzle positions but no joint values.</source>
        <translation>Braccio, giunti e loro limiti: non verificati, perché il programma contiene posizioni dell&apos;ugello ma non valori dei giunti.</translation>
    </message>
    <message>
        <source>The largest scale that the cell&apos;s plates carry</source>
        <translation>La scala massima che i piatti della cella portano</translation>
    </message>
    <message>
        <source>The part&apos;s footprint plus 20 mm, on its own stem</source>
        <translation>La base del pezzo più 20 mm, su un proprio gambo</translation>
    </message>
    <message>
        <source>Bead section: off by more than 5 % over {share:.2f} of the printed length; at most {limit:.0f} allowed.</source>
        <translation>Sezione del cordone: errata di oltre il 5 % sul {share:.2f} della lunghezza stampata; ammesso al massimo {limit:.0f}.</translation>
    </message>
    <message>
        <source>Built in</source>
        <translation>Costruito in</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cella</translation>
    </message>
    <message>
        <source>Chosen: {way} ({values})</source>
        <translation>Scelta: {way} ({values})</translation>
    </message>
    <message>
        <source>Close the openings</source>
        <translation>Chiudi le aperture</translation>
    </message>
    <message>
        <source>Minimum clearance between arm, plate and part: {way:.1f}.</source>
        <translation>Distanza minima fra braccio, piatto e pezzo: {way:.1f}.</translation>
    </message>
    <message>
        <source>Collisions of head, plate and part: {collisions}; none allowed.</source>
        <translation>Collisioni di testa, piatto e pezzo: {collisions}; nessuna è ammessa.</translation>
    </message>
    <message>
        <source>Collisions: {collisions}; none allowed.</source>
        <translation>Collisioni: {collisions}; nessuna è ammessa.</translation>
    </message>
    <message>
        <source>Fill: {share:.1f} of the part is filled; at least {limit:.4g} required.</source>
        <translation>Riempimento: è pieno il {share:.1f} del pezzo; richiesto {limit:.4g}.</translation>
    </message>
    <message>
        <source>Flat patches over the openings: the part becomes solid</source>
        <translation>Toppe piane sulle aperture: il pezzo diventa solido</translation>
    </message>
    <message>
        <source>G-code with B and C: beyond this number of turns to one side C is reset by whole turns during a travel. 0: the minimum the beads allow if the table is wound back, one turn if only its count is reset.</source>
        <translation>G-code con B e C: oltre questo numero di giri da un lato C torna indietro di giri interi durante uno spostamento. 0: il minimo che i cordoni permettono se la tavola viene riavvolta, un giro se torna indietro il solo conteggio.</translation>
    </message>
    <message>
        <source>G-code with B and C: winds the table back during a travel, with the nozzle raised clear of it. For a table that turns endlessly only the count can be reset, without a motion.</source>
        <translation>G-code con B e C: riavvolge la tavola durante uno spostamento, con l&apos;ugello sollevato. Per una tavola che gira senza fine può tornare indietro il solo conteggio, senza movimento.</translation>
    </message>
    <message>
        <source>G94 is missing after the last motion: the next program would read F as times</source>
        <translation>G94 manca dopo l&apos;ultimo movimento: il programma seguente prenderebbe F per tempi</translation>
    </message>
    <message>
        <source>Half the layer height, within the process&apos;s range</source>
        <translation>Metà altezza dello strato, entro i limiti del processo</translation>
    </message>
    <message>
        <source>50 % larger</source>
        <translation>50 % più grande</translation>
    </message>
    <message>
        <source>Half the distance of the arm from itself and from the part</source>
        <translation>Metà della distanza del braccio da sé stesso e dal pezzo</translation>
    </message>
    <message>
        <source>Partly supported: {share:.1f} of the bead length is supported over less than half its width.</source>
        <translation>Appoggio parziale: il {share:.1f} della lunghezza dei cordoni poggia su meno di metà larghezza.</translation>
    </message>
    <message>
        <source>In a usual cell; Voluta chooses the way of building</source>
        <translation>In una cella abituale; Voluta sceglie il modo di costruire</translation>
    </message>
    <message>
        <source>It is for another controller than the cell&apos;s.</source>
        <translation>È per un controllore diverso da quello della cella.</translation>
    </message>
    <message>
        <source>It prints the rest of a stopped print.</source>
        <translation>Stampa il resto di una stampa interrotta.</translation>
    </message>
    <message>
        <source>Joint range: joint {name} has the smallest margin to its limit, {angle:.1f}.</source>
        <translation>Corsa dei giunti: il giunto {name} ha il margine minore dal limite, {angle:.1f}.</translation>
    </message>
    <message>
        <source>Joint speed: joint {name} is closest to its limit, at {share:.0f} of it.</source>
        <translation>Velocità dei giunti: il giunto {name} è il più vicino al limite, al {share:.0f}.</translation>
    </message>
    <message>
        <source>Keep more clearance</source>
        <translation>Tieni più distanza</translation>
    </message>
    <message>
        <source>Limits of flow and blends: {violations} violations; none allowed.</source>
        <translation>Limiti di portata e raccordi: {violations} violazioni; nessuna è ammessa.</translation>
    </message>
    <message>
        <source>Limits of joints, speeds and flow: {violations} violations; none allowed.</source>
        <translation>Limiti di giunti, velocità e portata: {violations} violazioni; nessuna è ammessa.</translation>
    </message>
    <message>
        <source>Longer programs are split into files to run one after the other. 0: the format&apos;s default (URScript and RAPID 5000, KRL 2500, MELFA 6500, SPEL+ one file).</source>
        <translation>I programmi più lunghi sono divisi in file da eseguire uno dopo l&apos;altro. 0: come prevede il formato (URScript e RAPID 5000, KRL 2500, MELFA 6500, SPEL+ un file solo).</translation>
    </message>
    <message>
        <source>Longest unsupported run: {length:.1f}; this material bridges {bridge:.1f}.</source>
        <translation>Tratto più lungo senza appoggio: {length:.1f}; questo materiale supera {bridge:.1f}.</translation>
    </message>
    <message>
        <source>Make a platform for the part</source>
        <translation>Fai una piattaforma per il pezzo</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>No way of building passes; the best one is shown: {way} ({values})</source>
        <translation>Nessun modo di costruzione passa; si mostra il migliore: {way} ({values})</translation>
    </message>
    <message>
        <source>The default nozzle, head and material of this way of building</source>
        <translation>Ugello, testa e materiale predefiniti di questo modo di costruire</translation>
    </message>
    <message>
        <source>G{number} is not understood</source>
        <translation>G{number} non è compreso</translation>
    </message>
    <message>
        <source>Height after which the layers turn in the other direction, again and again; 0: never.</source>
        <translation>Altezza dopo la quale gli strati girano nell&apos;altro verso, ogni volta di nuovo; 0: mai.</translation>
    </message>
    <message>
        <source>Material of the file&apos;s tool-paths, in percent of its amounts. For a file that was read with another filament diameter: 100 times the square of their ratio (2.85 mm instead of 1.75 mm: 265).</source>
        <translation>Materiale dei percorsi del file, in percento delle sue quantità. Per un file letto con un altro diametro del filamento: 100 per il quadrato del loro rapporto (2,85 mm invece di 1,75 mm: 265).</translation>
    </message>
    <message>
        <source>Moves the file&apos;s tool-paths to x,y,z,a,b,c: mm, and degrees about the fixed axes x, y and z in this order; e.g. onto a side of the platform&apos;s body. Empty: no motion.</source>
        <translation>Sposta i percorsi del file in x,y,z,a,b,c: mm, e gradi attorno agli assi fissi x, y e z in quest&apos;ordine; ad esempio su un lato del corpo della piattaforma. Vuoto: nessuno spostamento.</translation>
    </message>
    <message>
        <source>On a cylinder or sphere: each layer keeps the lengths of the file, or the angle of the layer below, so that it grows with the radius and its beads with it.</source>
        <translation>Su un cilindro o una sfera: ogni strato mantiene le lunghezze del file, oppure l&apos;angolo dello strato sottostante, così che cresca con il raggio e i suoi cordoni con esso.</translation>
    </message>
    <message>
        <source>Paths of the file</source>
        <translation>Percorsi del file</translation>
    </message>
    <message>
        <source>Radius of that cylinder or sphere; negative: its inside.</source>
        <translation>Raggio di quel cilindro o di quella sfera; negativo: il suo interno.</translation>
    </message>
    <message>
        <source>Turns each layer of the file&apos;s tool-paths about z against the one below; positive: counterclockwise.</source>
        <translation>Gira ogni strato dei percorsi del file attorno a z rispetto a quello sottostante; positivo: in senso antiorario.</translation>
    </message>
    <message>
        <source>Where the file&apos;s tool-paths are printed: on the plate; on a block with a plane top, which is turned together with them; or bent onto a cylinder along x or a sphere. The block is made for the part, unless the platform is a body.</source>
        <translation>Dove si stampano i percorsi del file: sul piano; su un blocco con la faccia superiore piana, girato insieme a loro; oppure piegati su un cilindro lungo x o su una sfera. Il blocco è fatto per il pezzo, a meno che la piattaforma sia un corpo.</translation>
    </message>
    <message>
        <source>a bead from an unknown position</source>
        <translation>un cordone da una posizione sconosciuta</translation>
    </message>
    <message>
        <source>a direction of length 0</source>
        <translation>una direzione di lunghezza 0</translation>
    </message>
    <message>
        <source>a length of filament of more than a kilometre</source>
        <translation>una lunghezza di filamento di più di un chilometro</translation>
    </message>
    <message>
        <source>a motion with a word A, U, V or W is not understood</source>
        <translation>un movimento con una parola A, U, V o W non è compreso</translation>
    </message>
    <message>
        <source>a position more than a kilometre away</source>
        <translation>una posizione a più di un chilometro</translation>
    </message>
    <message>
        <source>a position without G0 or G1</source>
        <translation>una posizione senza G0 o G1</translation>
    </message>
    <message>
        <source>amount</source>
        <translation>quantità</translation>
    </message>
    <message>
        <source>an arc that does not pass through its ends</source>
        <translation>un arco che non passa per i suoi estremi</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>angoli</translation>
    </message>
    <message>
        <source>bent layers keep</source>
        <translation>gli strati piegati mantengono</translation>
    </message>
    <message>
        <source>contains no beads of a part</source>
        <translation>non contiene cordoni di un pezzo</translation>
    </message>
    <message>
        <source>contains no beads: no motion extrudes</source>
        <translation>non contiene cordoni: nessun movimento estrude</translation>
    </message>
    <message>
        <source>export G-code as text from the slicer</source>
        <translation>esportare il G-code come testo dallo slicer</translation>
    </message>
    <message>
        <source>export straight lines, or arcs in the plane of X and Y (G2, G3)</source>
        <translation>esportare tratti rettilinei, o archi nel piano di X e Y (G2, G3)</translation>
    </message>
    <message>
        <source>export the G-code with extrusion (E)</source>
        <translation>esportare il G-code con l&apos;estrusione (E)</translation>
    </message>
    <message>
        <source>export the G-code with extrusion (E) from a slicer</source>
        <translation>esportare il G-code con l&apos;estrusione (E) da uno slicer</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>riferimento</translation>
    </message>
    <message>
        <source>give F in mm per minute</source>
        <translation>dare F in mm al minuto</translation>
    </message>
    <message>
        <source>give a larger `pathsRadiusMm`</source>
        <translation>dare un `pathsRadiusMm` maggiore</translation>
    </message>
    <message>
        <source>give a larger `pathsRadiusMm`, or turn the part by 90 degrees</source>
        <translation>dare un `pathsRadiusMm` maggiore, o girare il pezzo di 90 gradi</translation>
    </message>
    <message>
        <source>give at least 1 mm, or at most -1 mm for the inside</source>
        <translation>dare almeno 1 mm, o al più -1 mm per l&apos;interno</translation>
    </message>
    <message>
        <source>give its centre (I, J) or its radius (R)</source>
        <translation>dare il suo centro (I, J) o il suo raggio (R)</translation>
    </message>
    <message>
        <source>give nX nY nZ as a unit vector</source>
        <translation>dare nX nY nZ come vettore unitario</translation>
    </message>
    <message>
        <source>give the nozzle&apos;s direction as nX nY nZ, or the table&apos;s angles as B and C</source>
        <translation>dare la direzione dell&apos;ugello come nX nY nZ, o gli angoli della tavola come B e C</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>base</translation>
    </message>
    <message>
        <source>home the axes (G28) or travel to its start first</source>
        <translation>azzerare gli assi (G28) o andare prima al suo inizio</translation>
    </message>
    <message>
        <source>is binary G-code</source>
        <translation>è G-code binario</translation>
    </message>
    <message>
        <source>lengths</source>
        <translation>lunghezze</translation>
    </message>
    <message>
        <source>`pathsFrame` &apos;{text}&apos; is not a frame</source>
        <translation>`pathsFrame` &apos;{text}&apos; non è un riferimento</translation>
    </message>
    <message>
        <source>`pathsRadiusMm={radius}` is no radius of a ground</source>
        <translation>`pathsRadiusMm={radius}` non è un raggio valido</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>piano inclinabile</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>piano di stampa</translation>
    </message>
    <message>
        <source>slice with comments, or with layers of one height</source>
        <translation>esportare con i commenti, o con strati di una sola altezza</translation>
    </message>
    <message>
        <source>the file may be damaged; export it again</source>
        <translation>il file può essere danneggiato; esportarlo di nuovo</translation>
    </message>
    <message>
        <source>the file states no filament diameter: {diameter} assumed; for another one set `pathsFlow`</source>
        <translation>il file non indica il diametro del filamento: si assume {diameter}; per un altro impostare `pathsFlow`</translation>
    </message>
    <message>
        <source>a bead at X{x:.1f} Y{y:.1f} Z{z:.1f} is {width:.0f} wide</source>
        <translation>un cordone in X{x:.1f} Y{y:.1f} Z{z:.1f} è largo {width:.0f}</translation>
    </message>
    <message>
        <source>correct the amount (E) of that line, or the filament&apos;s diameter</source>
        <translation>correggere la quantità (E) di quella riga, o il diametro del filamento</translation>
    </message>
    <message>
        <source>the height of the beads is not known</source>
        <translation>l&apos;altezza dei cordoni non è nota</translation>
    </message>
    <message>
        <source>the part is {height:.1f} high, too high for the inside of a radius of {radius:.1f}</source>
        <translation>il pezzo è alto {height:.1f}, troppo per l&apos;interno di un raggio di {radius:.1f}</translation>
    </message>
    <message>
        <source>the part reaches {angle:.0f} round the ground, more than 90</source>
        <translation>il pezzo si estende per {angle:.0f} attorno alla base, più di 90</translation>
    </message>
    <message>
        <source>turn back after</source>
        <translation>inversione dopo</translation>
    </message>
    <message>
        <source>turn per layer</source>
        <translation>rotazione per strato</translation>
    </message>
    <message>
        <source>write the command in each line</source>
        <translation>scrivere il comando in ogni riga</translation>
    </message>
    <message>
        <source>write x,y,z,a,b,c in mm and degrees</source>
        <translation>scrivere x,y,z,a,b,c in mm e gradi</translation>
    </message>
    <message>
        <source>{volume:.0f} extruded before the first layer are left out</source>
        <translation>{volume:.0f} estrusi prima del primo strato sono omessi</translation>
    </message>
    <message>
        <source>Open surfaces</source>
        <translation>Superfici aperte</translation>
    </message>
    <message>
        <source>Overfill: {share:.1f} of the part&apos;s volume lies outside it or in places already full; at most {limit:.4g} allowed.</source>
        <translation>Eccesso: il {share:.1f} del volume del pezzo è fuori da esso o in punti già pieni; ammesso al massimo {limit:.4g}.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Passed: this program prints the part as planned.</source>
        <translation>Superato: questo programma stampa il pezzo come previsto.</translation>
    </message>
    <message>
        <source>Path: the nozzle deviates from the planned path by up to {way:.3f}; at most {limit:.2f} allowed.</source>
        <translation>Percorso: l&apos;ugello si scosta dal percorso previsto di {way:.3f} al massimo; ammesso {limit:.2f}.</translation>
    </message>
    <message>
        <source>Planned
time</source>
        <translation>Tempo
previsto</translation>
    </message>
    <message>
        <source>Positions are in mm in the work frame: origin at the centre of the platform&apos;s top, z pointing out of it. The printed part as a solid: {file}</source>
        <translation>Le posizioni sono in mm nel sistema di lavoro: origine al centro del piano della piattaforma, z verso l&apos;esterno. Il pezzo stampato, come solido: {file}</translation>
    </message>
    <message>
        <source>Prime</source>
        <translation>Innesco</translation>
    </message>
    <message>
        <source>Print it larger</source>
        <translation>Stampalo più grande</translation>
    </message>
    <message>
        <source>Print it smaller</source>
        <translation>Stampalo più piccolo</translation>
    </message>
    <message>
        <source>Print thinner layers</source>
        <translation>Stampa strati più sottili</translation>
    </message>
    <message>
        <source>Print on a plate</source>
        <translation>Stampa su un piatto</translation>
    </message>
    <message>
        <source>Print time</source>
        <translation>Tempo di stampa</translation>
    </message>
    <message>
        <source>Program files with their SHA-256</source>
        <translation>File del programma, con lo SHA-256 di ciascuno</translation>
    </message>
    <message>
        <source>Refused: do not run this program.</source>
        <translation>Rifiutato: non eseguire questo programma.</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>The default robot and plate of this way of building</source>
        <translation>Robot e piatto predefiniti di questo modo di costruire</translation>
    </message>
    <message>
        <source>Singularities: isotropy is at least {ratio:.3f} (0 is singular, 1 is isotropic).</source>
        <translation>Singolarità: l&apos;isotropia è almeno {ratio:.3f} (0 è singolare, 1 è isotropo).</translation>
    </message>
    <message>
        <source>The next cell with a larger plate</source>
        <translation>La prossima cella con un piatto più grande</translation>
    </message>
    <message>
        <source>The cell&apos;s smallest plate that carries the part</source>
        <translation>Il più piccolo dei piatti della cella che porta il pezzo</translation>
    </message>
    <message>
        <source>Thicken to a wall</source>
        <translation>Ispessisci a parete</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Utensile</translation>
    </message>
    <message>
        <source>Try more rotations</source>
        <translation>Prova più rotazioni</translation>
    </message>
    <message>
        <source>Trying {way} ({number} of {count})</source>
        <translation>Prova di {way} ({number} di {count})</translation>
    </message>
    <message>
        <source>Twice as many rotations about the nozzle per point; planning takes longer</source>
        <translation>Il doppio delle rotazioni attorno all&apos;ugello in ogni punto; la pianificazione dura di più</translation>
    </message>
    <message>
        <source>Twice the distance of the arm from itself and from the part</source>
        <translation>Il doppio della distanza del braccio da sé stesso e dal pezzo</translation>
    </message>
    <message>
        <source>Two beads wide, centred on the surface</source>
        <translation>Larga due cordoni, centrata sulla superficie</translation>
    </message>
    <message>
        <source>Unsupported: {share:.2f} of the bead length; at most {limit:.4g} allowed.</source>
        <translation>Senza appoggio: il {share:.2f} della lunghezza dei cordoni; ammesso al massimo {limit:.4g}.</translation>
    </message>
    <message>
        <source>Use a larger cell</source>
        <translation>Usa una cella più grande</translation>
    </message>
    <message>
        <source>Use longer motions</source>
        <translation>Usa movimenti più lunghi</translation>
    </message>
    <message>
        <source>Use shorter motions</source>
        <translation>Usa movimenti più corti</translation>
    </message>
    <message>
        <source>Use the cell&apos;s plate</source>
        <translation>Usa il piatto della cella</translation>
    </message>
    <message>
        <source>Use the usual cell</source>
        <translation>Usa la cella abituale</translation>
    </message>
    <message>
        <source>Use the usual process</source>
        <translation>Usa il processo abituale</translation>
    </message>
    <message numerus="yes">
        <source>Voluta read the program back, moved the nozzle along it without an arm, and found {checks} checks failed.</source>
        <translation>
            <numerusform>Voluta ha riletto il programma, ha mosso l&apos;ugello lungo di esso senza un braccio e {checks} verifica non è superata.</numerusform>
            <numerusform>Voluta ha riletto il programma, ha mosso l&apos;ugello lungo di esso senza un braccio e {checks} verifiche non sono superate.</numerusform>
        </translation>
    </message>
    <message>
        <source>Voluta read the program back, moved the nozzle along it without an arm, and measured what it prints.</source>
        <translation>Voluta ha riletto il programma, ha mosso l&apos;ugello lungo di esso senza un braccio e ha misurato ciò che stampa.</translation>
    </message>
    <message numerus="yes">
        <source>Voluta read the program back, ran it on a model of the robot and its controller, and found {checks} checks failed.</source>
        <translation>
            <numerusform>Voluta ha riletto il programma, l&apos;ha eseguito su un modello del robot e del suo controllore e {checks} verifica non è superata.</numerusform>
            <numerusform>Voluta ha riletto il programma, l&apos;ha eseguito su un modello del robot e del suo controllore e {checks} verifiche non sono superate.</numerusform>
        </translation>
    </message>
    <message>
        <source>Voluta read the program back, ran it on a model of the robot and its controller, and measured what it prints.</source>
        <translation>Voluta ha riletto il programma, l&apos;ha eseguito su un modello del robot e del suo controllore e ha misurato ciò che stampa.</translation>
    </message>
    <message>
        <source>Voluta {version}, {date}</source>
        <translation>Voluta {version}, {date}</translation>
    </message>
    <message>
        <source>Half the waypoint spacing; the program gets longer</source>
        <translation>Metà della distanza fra i punti; il programma si allunga</translation>
    </message>
    <message>
        <source>Twice the waypoint spacing</source>
        <translation>Il doppio della distanza fra i punti</translation>
    </message>
    <message>
        <source>Checks, with the closest approach to each limit</source>
        <translation>Verifiche, con il punto più vicino a ciascun limite</translation>
    </message>
    <message>
        <source>Modules and signal list for this controller: IRC5 (RobotWare 6) or OmniCore (RobotWare 7).</source>
        <translation>Moduli ed elenco di segnali per questo controllore: IRC5 (RobotWare 6) oppure OmniCore (RobotWare 7).</translation>
    </message>
    <message>
        <source>a ball refers to the missing vertex {vertex}</source>
        <translation>una sfera indica il vertice {vertex}, che non esiste</translation>
    </message>
    <message>
        <source>a beam refers to the missing vertex {vertex}</source>
        <translation>una trave indica il vertice {vertex}, che non esiste</translation>
    </message>
    <message>
        <source>a beam without a radius</source>
        <translation>una trave senza raggio</translation>
    </message>
    <message>
        <source>a picture of the sheet is not a PNG</source>
        <translation>un&apos;immagine del foglio non è un PNG</translation>
    </message>
    <message>
        <source>a stop until the operator continues</source>
        <translation>un arresto finché l&apos;operatore non prosegue</translation>
    </message>
    <message>
        <source>a trigger for the output</source>
        <translation>un trigger per l&apos;uscita</translation>
    </message>
    <message>
        <source>a wait until the nozzle is hot</source>
        <translation>un&apos;attesa finché l&apos;ugello è caldo</translation>
    </message>
    <message>
        <source>a wall of {wall:.2f} is too thin for a surface of this size: it would need {facets:.2g} triangles</source>
        <translation>una parete di {wall:.2f} è troppo sottile per una superficie di queste dimensioni: richiederebbe {facets:.2g} triangoli</translation>
    </message>
    <message>
        <source>absolute positions</source>
        <translation>posizioni assolute</translation>
    </message>
    <message>
        <source>after {time}</source>
        <translation>dopo {time}</translation>
    </message>
    <message>
        <source>an object of the unknown type &apos;{type}&apos;</source>
        <translation>un oggetto del tipo sconosciuto &apos;{type}&apos;</translation>
    </message>
    <message>
        <source>an extruder output is set while the arm is moving: it switches at the wrong place, or stops the arm on the bead</source>
        <translation>un&apos;uscita dell&apos;estrusore viene impostata mentre il braccio si muove: commuta nel punto sbagliato, o ferma il braccio sul cordone</translation>
    </message>
    <message>
        <source>according to the robot&apos;s controller</source>
        <translation>secondo il controllore del robot</translation>
    </message>
    <message>
        <source>at {place:.1f}</source>
        <translation>in {place:.1f}</translation>
    </message>
    <message>
        <source>clear this place, or use a larger plate (`--platform`)</source>
        <translation>liberare questo punto, oppure usare un piano più grande (`--platform`)</translation>
    </message>
    <message>
        <source>close</source>
        <translation>chiudi</translation>
    </message>
    <message>
        <source>open edges were closed: {share:.3g} of the surface is patches</source>
        <translation>bordi aperti chiusi: il {share:.3g} della superficie è fatto di toppe</translation>
    </message>
    <message>
        <source>curved layers</source>
        <translation>strati curvi</translation>
    </message>
    <message>
        <source>curved layers on a pedestal</source>
        <translation>strati curvi su un piedistallo</translation>
    </message>
    <message>
        <source>curved layers with supports</source>
        <translation>strati curvi con supporti</translation>
    </message>
    <message>
        <source>decimal commas read as decimal points</source>
        <translation>virgole decimali lette come punti decimali</translation>
    </message>
    <message>
        <source>export it as a triangle mesh</source>
        <translation>esportalo come mesh di triangoli</translation>
    </message>
    <message>
        <source>export it with decimal points</source>
        <translation>esportalo con il punto decimale</translation>
    </message>
    <message>
        <source>flat layers</source>
        <translation>strati piani</translation>
    </message>
    <message>
        <source>flat layers with supports</source>
        <translation>strati piani con supporti</translation>
    </message>
    <message>
        <source>footprint of the part: {length:.0f} by {width:.0f}, larger than the cell&apos;s largest plate ({plate})</source>
        <translation>base del pezzo: {length:.0f} per {width:.0f}, più grande del piatto più grande della cella ({plate})</translation>
    </message>
    <message>
        <source>has a disc inside another</source>
        <translation>ha un disco dentro un altro</translation>
    </message>
    <message>
        <source>contains nothing to print: {what}</source>
        <translation>non contiene nulla da stampare: {what}</translation>
    </message>
    <message>
        <source>contains sliced G-code (&apos;{member}&apos;) and no model</source>
        <translation>contiene G-code già affettato (&apos;{member}&apos;) e nessun modello</translation>
    </message>
    <message>
        <source>the counting mode of the filament</source>
        <translation>il modo di contare il filamento</translation>
    </message>
    <message>
        <source>parameter {key} no longer exists: its value has no effect</source>
        <translation>il parametro {key} non esiste più: il suo valore non ha effetto</translation>
    </message>
    <message>
        <source>parameter {oldKey} was renamed to {key}</source>
        <translation>il parametro {oldKey} ora si chiama {key}</translation>
    </message>
    <message>
        <source>is damaged or truncated UTF-16</source>
        <translation>è in UTF-16 danneggiato o troncato</translation>
    </message>
    <message>
        <source>is UTF-32, which cannot be read</source>
        <translation>è in UTF-32, che non si può leggere</translation>
    </message>
    <message>
        <source>is not one of the colours: &apos;{name}&apos;</source>
        <translation>non è tra i colori: &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>stored as text in an older project: plan again to see remedies</source>
        <translation>conservato come testo in un progetto più vecchio: pianifica di nuovo per vedere i rimedi</translation>
    </message>
    <message>
        <source>layer height {height}, platform: {platform}</source>
        <translation>altezza degli strati {height}, piattaforma: {platform}</translation>
    </message>
    <message>
        <source>layer height {height}, supports: {supports}, platform: {platform}</source>
        <translation>altezza degli strati {height}, supporti: {supports}, piattaforma: {platform}</translation>
    </message>
    <message>
        <source>layer {layer}</source>
        <translation>strato {layer}</translation>
    </message>
    <message>
        <source>sheets without thickness were left out: {share:.3g} of the surface, {triangles} triangles</source>
        <translation>lamine senza spessore escluse: il {share:.3g} della superficie, {triangles} triangoli</translation>
    </message>
    <message>
        <source>less than {share:.0f}</source>
        <translation>meno del {share:.0f}</translation>
    </message>
    <message>
        <source>line {line} of {file}</source>
        <translation>riga {line} di {file}</translation>
    </message>
    <message>
        <source>millimetres as the unit of length</source>
        <translation>i millimetri come unità di lunghezza</translation>
    </message>
    <message>
        <source>missing before this line: {statement}</source>
        <translation>manca prima di questa riga: {statement}</translation>
    </message>
    <message>
        <source>must be a colour like &quot;#d0d4d8&quot;</source>
        <translation>deve essere un colore come &quot;#d0d4d8&quot;</translation>
    </message>
    <message>
        <source>must be in 1..{most}</source>
        <translation>deve essere in 1..{most}</translation>
    </message>
    <message>
        <source>must hold as many discs as the first, at least one</source>
        <translation>deve contenere tanti dischi quanti la prima, almeno uno</translation>
    </message>
    <message>
        <source>must hold at least one solid</source>
        <translation>deve contenere almeno un solido</translation>
    </message>
    <message>
        <source>must hold {wanted} values, holds {found}</source>
        <translation>deve contenere {wanted} valori, ne contiene {found}</translation>
    </message>
    <message>
        <source>must not be along the axis</source>
        <translation>non deve essere lungo l&apos;asse</translation>
    </message>
    <message>
        <source>must not be before the previous one</source>
        <translation>non deve stare prima di quella precedente</translation>
    </message>
    <message>
        <source>no available process has narrower beads</source>
        <translation>nessun processo disponibile ha cordoni più stretti</translation>
    </message>
    <message>
        <source>nothing is left: no triangle has area or encloses a volume</source>
        <translation>non resta nulla: nessun triangolo ha area o racchiude un volume</translation>
    </message>
    <message>
        <source>nozzle {nozzle}, bead {width#} x {height}</source>
        <translation>ugello {nozzle}, cordone {width#} x {height}</translation>
    </message>
    <message>
        <source>numbers with decimal commas, such as &apos;{number}&apos;, mixed with numbers with decimal points</source>
        <translation>numeri con la virgola, come &apos;{number}&apos;, mescolati a numeri con il punto</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; has a beam lattice clipped by a mesh, which cannot be read</source>
        <translation>l&apos;oggetto &apos;{id}&apos; ha un reticolo di travi tagliato da una mesh, che non si può leggere</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; is stored as slices (slicestack), which cannot be read</source>
        <translation>l&apos;oggetto &apos;{id}&apos; è dato a strati (slicestack), che non si possono leggere</translation>
    </message>
    <message>
        <source>change the cell&apos;s file: Edit, Edit cell</source>
        <translation>cambia il file della cella: Modifica, Modifica cella</translation>
    </message>
    <message numerus="yes">
        <source>open surface: {rims} open edge loops, the widest {width:.3g} wide</source>
        <translation>
            <numerusform>superficie aperta: {rims} bordo aperto, largo {width:.3g}</numerusform>
            <numerusform>superficie aperta: {rims} bordi aperti, il più largo {width:.3g}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>open surface: it ends at {rims} rims, the widest {width:.3g} wide at {at:.1f}</source>
        <translation>
            <numerusform>superficie aperta: finisce in {rims} bordo, largo {width:.3g} a {at:.1f}</numerusform>
            <numerusform>superficie aperta: finisce in {rims} bordi, il più largo {width:.3g} a {at:.1f}</numerusform>
        </translation>
    </message>
    <message>
        <source>open the model that it was sliced from</source>
        <translation>apri il modello da cui è stato affettato</translation>
    </message>
    <message>
        <source>to get a solid instead, use `openSurfaces=close`</source>
        <translation>per ottenere invece un solido, usa `openSurfaces=close`</translation>
    </message>
    <message>
        <source>to get a wall instead, use `openSurfaces=thicken`</source>
        <translation>per ottenere invece una parete, usa `openSurfaces=thicken`</translation>
    </message>
    <message>
        <source>to get walls instead, use `openSurfaces=thicken`</source>
        <translation>per ottenere invece delle pareti, usa `openSurfaces=thicken`</translation>
    </message>
    <message>
        <source>pieces with supports</source>
        <translation>parti piane con supporti</translation>
    </message>
    <message>
        <source>planned time</source>
        <translation>tempo previsto</translation>
    </message>
    <message>
        <source>print the part at scale {scale}, or use a cell with a larger plate or a platform made for the part</source>
        <translation>stampa il pezzo in scala {scale}, oppure usa una cella con un piatto più grande o una piattaforma fatta per il pezzo</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>rifiuta</translation>
    </message>
    <message numerus="yes">
        <source>removed the self-intersections of {count} components</source>
        <translation>
            <numerusform>autointersezioni rimosse da {count} componente</numerusform>
            <numerusform>autointersezioni rimosse da {count} componenti</numerusform>
        </translation>
    </message>
    <message>
        <source>save it as UTF-8</source>
        <translation>salvalo come UTF-8</translation>
    </message>
    <message>
        <source>set it by a trigger of the next motion, or write the program again</source>
        <translation>impostarla con un trigger del movimento seguente, o riscrivere il programma</translation>
    </message>
    <message>
        <source>sheet model: {share:.3g} of the surface has no thickness, {triangles} triangles</source>
        <translation>modello a lamine: il {share:.3g} della superficie è senza spessore, {triangles} triangoli</translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} items marked as not printable</source>
        <translation>
            <numerusform>saltato: {count} elemento contrassegnato come non stampabile</numerusform>
            <numerusform>saltati: {count} elementi contrassegnati come non stampabili</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects of type &apos;other&apos;, which are not printed</source>
        <translation>
            <numerusform>saltato: {count} oggetto di tipo &apos;other&apos;, che non si stampa</numerusform>
            <numerusform>saltati: {count} oggetti di tipo &apos;other&apos;, che non si stampano</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects of type &apos;surface&apos;, which are not solids</source>
        <translation>
            <numerusform>saltato: {count} oggetto di tipo &apos;surface&apos;, che non è un solido</numerusform>
            <numerusform>saltati: {count} oggetti di tipo &apos;surface&apos;, che non sono solidi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects without a mesh</source>
        <translation>
            <numerusform>saltato: {count} oggetto senza mesh</numerusform>
            <numerusform>saltati: {count} oggetti senza mesh</numerusform>
        </translation>
    </message>
    <message>
        <source>contains {parts} parts, of which {limit} can be printed</source>
        <translation>contiene {parts} pezzi, di cui se ne possono stampare {limit}</translation>
    </message>
    <message>
        <source>open it as one part</source>
        <translation>aprilo come un solo pezzo</translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} support objects</source>
        <translation>
            <numerusform>saltato: {count} oggetto di supporto</numerusform>
            <numerusform>saltati: {count} oggetti di supporto</numerusform>
        </translation>
    </message>
    <message>
        <source>the PDF could not be created: {why}</source>
        <translation>il PDF non è stato creato: {why}</translation>
    </message>
    <message>
        <source>the arm passes this point at {stated:.1f} mm/s with unchanged flow; the path requires {suits:.1f} mm/s</source>
        <translation>il braccio passa per questo punto a {stated:.1f} mm/s con portata invariata; il percorso richiede {suits:.1f} mm/s</translation>
    </message>
    <message>
        <source>the robot dwells here for {time:.2f} with the hot nozzle touching the part</source>
        <translation>il robot sosta qui per {time:.2f} con l&apos;ugello caldo a contatto con il pezzo</translation>
    </message>
    <message>
        <source>the arm&apos;s posture at this target: {found} in the program, {planned} planned</source>
        <translation>la postura del braccio in questo punto: {found} nel programma, {planned} prevista</translation>
    </message>
    <message>
        <source>choose the bead to resume from on the Simulate page</source>
        <translation>scegli il cordone da cui riprendere nella pagina Simula</translation>
    </message>
    <message>
        <source>the rounding distances of corners</source>
        <translation>le distanze con cui si arrotondano gli angoli</translation>
    </message>
    <message>
        <source>the reference run</source>
        <translation>la corsa al punto di riferimento</translation>
    </message>
    <message>
        <source>see the remedies of the findings before this one</source>
        <translation>vedi i rimedi delle segnalazioni precedenti</translation>
    </message>
    <message>
        <source>the frame of the targets</source>
        <translation>il sistema di riferimento dei punti</translation>
    </message>
    <message>
        <source>the full flow</source>
        <translation>la portata massima</translation>
    </message>
    <message>
        <source>the mechanical unit</source>
        <translation>l&apos;unità meccanica</translation>
    </message>
    <message>
        <source>the message says how to fix it</source>
        <translation>il messaggio dice come rimediare</translation>
    </message>
    <message>
        <source>the part as printed, every bead laid</source>
        <translation>il pezzo stampato, con tutti i cordoni deposti</translation>
    </message>
    <message>
        <source>no room on the plate for the prime: a bead {length:.0f} long is printed in the air beside the plate and falls down here</source>
        <translation>nessun posto sul piano per l&apos;innesco: un cordone lungo {length:.0f} viene stampato in aria accanto al piano e cade qui</translation>
    </message>
    <message>
        <source>the program does not match this plan: changing the plan does not help</source>
        <translation>il programma non corrisponde a questo piano: cambiare il piano non serve</translation>
    </message>
    <message>
        <source>the range of the flow output</source>
        <translation>l&apos;intervallo dell&apos;uscita di portata</translation>
    </message>
    <message>
        <source>self-intersecting surface: {share:.3g} of the enclosed volume is inside out and counts as outside</source>
        <translation>superficie autointersecante: il {share:.3g} del volume racchiuso è rovesciato e vale come esterno</translation>
    </message>
    <message>
        <source>the nozzle temperature, °C</source>
        <translation>la temperatura dell&apos;ugello, °C</translation>
    </message>
    <message>
        <source>thicken</source>
        <translation>ispessisci</translation>
    </message>
    <message>
        <source>one wall</source>
        <translation>una sola parete</translation>
    </message>
    <message>
        <source>Print as one wall</source>
        <translation>Stampa come una sola parete</translation>
    </message>
    <message>
        <source>One bead wide, centred on the surface; its rims stay open</source>
        <translation>Larga un cordone, centrata sulla superficie; i bordi restano aperti</translation>
    </message>
    <message>
        <source>print it as one wall (`openSurfaces=wall`), thicken it to a wall of two beads (`openSurfaces=thicken`), close its rims to make it solid (`openSurfaces=close`), or close it in a modelling program</source>
        <translation>stampala come una sola parete (`openSurfaces=wall`), dalle lo spessore di una parete di due cordoni (`openSurfaces=thicken`), chiudi i bordi per farne un solido (`openSurfaces=close`) o chiudila in un programma di modellazione</translation>
    </message>
    <message>
        <source>print the sheets as walls of one bead (`openSurfaces=wall`) or two (`openSurfaces=thicken`), or give them a thickness in a modelling program</source>
        <translation>stampa le lamine come pareti di un cordone (`openSurfaces=wall`) o di due (`openSurfaces=thicken`), o dai loro uno spessore in un programma di modellazione</translation>
    </message>
    <message>
        <source>thicken the surface in a modelling program</source>
        <translation>dai spessore alla superficie in un programma di modellazione</translation>
    </message>
    <message>
        <source>the open surface was thickened to a wall of {wall:.2f}, half on each side</source>
        <translation>la superficie aperta è diventata una parete di {wall:.2f}, metà per lato</translation>
    </message>
    <message>
        <source>thicken it to a wall of two beads (`openSurfaces=thicken`), or repair it in a modelling program</source>
        <translation>ispessiscila a una parete di due cordoni (`openSurfaces=thicken`) o riparala in un programma di modellazione</translation>
    </message>
    <message>
        <source>the open surface crosses itself at {places} pairs of triangles, the first at ({x:.4g}, {y:.4g}, {z:.4g})</source>
        <translation>la superficie aperta interseca sé stessa in {places} coppie di triangoli, la prima in ({x:.4g}, {y:.4g}, {z:.4g})</translation>
    </message>
    <message>
        <source>the open surface has only one side: it is twisted along {edges} edges, the first at ({x:.4g}, {y:.4g}, {z:.4g})</source>
        <translation>la superficie aperta ha un solo lato: è ritorta lungo {edges} spigoli, il primo in ({x:.4g}, {y:.4g}, {z:.4g})</translation>
    </message>
    <message>
        <source>the open surface branches at {edges} edges, the first at ({x:.4g}, {y:.4g}, {z:.4g})</source>
        <translation>la superficie aperta si dirama in {edges} spigoli, il primo in ({x:.4g}, {y:.4g}, {z:.4g})</translation>
    </message>
    <message>
        <source>to get a wall of two beads instead, use `openSurfaces=thicken`</source>
        <translation>per ottenere invece una parete di due cordoni, usa `openSurfaces=thicken`</translation>
    </message>
    <message>
        <source>the open surface is printed as one wall, one bead ({width:.2f}) wide</source>
        <translation>la superficie aperta è stampata come una sola parete, larga un cordone ({width:.2f})</translation>
    </message>
    <message numerus="yes">
        <source>converted {count} lattice beams into round bars</source>
        <translation>
            <numerusform>trasformata {count} trave di un reticolo in una barra tonda</numerusform>
            <numerusform>trasformate {count} travi di un reticolo in barre tonde</numerusform>
        </translation>
    </message>
    <message>
        <source>{bytes} bytes</source>
        <translation>{bytes} byte</translation>
    </message>
    <message>
        <source>{hours} h {minutes} min</source>
        <translation>{hours} h {minutes} min</translation>
    </message>
    <message numerus="yes">
        <source>{layers} layers, {way}</source>
        <translation>
            <numerusform>{layers} strato, {way}</numerusform>
            <numerusform>{layers} strati, {way}</numerusform>
        </translation>
    </message>
    <message>
        <source>{least:.0f#} to {most:.0f}</source>
        <translation>dal {least:.0f#} al {most:.0f}</translation>
    </message>
    <message>
        <source>{mass:.1f} g, supports and waste included</source>
        <translation>{mass:.1f} g, supporti e scarti compresi</translation>
    </message>
    <message>
        <source>{material}, {volume:.1f} cm3 at {density:.2f} g/cm3</source>
        <translation>{material}, {volume:.1f} cm³ a {density:.2f} g/cm³</translation>
    </message>
    <message>
        <source>{minutes} min {seconds} s</source>
        <translation>{minutes} min {seconds} s</translation>
    </message>
    <message>
        <source>{part}, {x:.1f#} x {y:.1f#} x {z:.1f}</source>
        <translation>{part}, {x:.1f#} x {y:.1f#} x {z:.1f}</translation>
    </message>
    <message>
        <source>{seconds} s</source>
        <translation>{seconds} s</translation>
    </message>
    <message>
        <source>at least {share:.0f} filled</source>
        <translation>pieno almeno per il {share:.0f}</translation>
    </message>
    <message>
        <source>{statement}: {found} in the program, {planned} planned</source>
        <translation>{statement}: {found} nel programma, {planned} previsto</translation>
    </message>
    <message>
        <source>{time} on its controller</source>
        <translation>{time} sul suo controllore</translation>
    </message>
    <message>
        <source>{way}, {height} each</source>
        <translation>{way}, alti {height}</translation>
    </message>
    <message>
        <source>a cut of the tape</source>
        <translation>un taglio del nastro</translation>
    </message>
    <message>
        <source>a pause for the operator</source>
        <translation>una pausa per l&apos;operatore</translation>
    </message>
    <message>
        <source>a tool change</source>
        <translation>un cambio utensile</translation>
    </message>
    <message>
        <source>feeding in place</source>
        <translation>avanzamento da fermo</translation>
    </message>
    <message>
        <source>is above 1</source>
        <translation>è maggiore di 1</translation>
    </message>
    <message>
        <source>mode {mode} needs a rod, but cell {cell} has none</source>
        <translation>la modalità {mode} ha bisogno di un&apos;asta, ma la cella {cell} non ne ha</translation>
    </message>
    <message>
        <source>must be #RRGGBB</source>
        <translation>deve essere #RRGGBB</translation>
    </message>
    <message>
        <source>nothing in this file is executed</source>
        <translation>nulla di questo file viene eseguito</translation>
    </message>
    <message>
        <source>one</source>
        <translation>uno</translation>
    </message>
    <message>
        <source>the report has no item</source>
        <translation>il rapporto non contiene parti</translation>
    </message>
    <message>
        <source>unknown material &apos;{id}&apos;</source>
        <translation>materiale &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>events of unequal number</source>
        <translation>eventi in numero diverso</translation>
    </message>
    <message>
        <source>Share of the interior that is filled: the whole is solid, none is hollow. Walls and skins are always solid.</source>
        <translation>Quota dell&apos;interno che viene riempita: tutta è pieno, nessuna è vuoto. Pareti e pelli sono sempre piene.</translation>
    </message>
    <message>
        <source>sparse pattern</source>
        <translation>motivo rado</translation>
    </message>
    <message>
        <source>Pattern of the interior if it is not solid.</source>
        <translation>Motivo dell&apos;interno se non è pieno.</translation>
    </message>
    <message>
        <source>top layers</source>
        <translation>strati superiori</translation>
    </message>
    <message>
        <source>Solid layers between the sparse interior and the surface above it.</source>
        <translation>Strati pieni tra l&apos;interno rado e la superficie sopra di esso.</translation>
    </message>
    <message>
        <source>bottom layers</source>
        <translation>strati inferiori</translation>
    </message>
    <message>
        <source>Solid layers between the sparse interior and the surface below it.</source>
        <translation>Strati pieni tra l&apos;interno rado e la superficie sotto di esso.</translation>
    </message>
    <message>
        <source>skin thickness</source>
        <translation>spessore della pelle</translation>
    </message>
    <message>
        <source>Minimum thickness of the top and bottom layers together with their number.</source>
        <translation>Spessore minimo degli strati superiori e inferiori, oltre al loro numero.</translation>
    </message>
    <message>
        <source>gyroid</source>
        <translation>giroide</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>linee</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>griglia</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triangoli</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>cubico</translation>
    </message>
    <message>
        <source>honeycomb</source>
        <translation>nido d&apos;ape</translation>
    </message>
    <message>
        <source>unknown sparse infill &apos;{id}&apos;</source>
        <translation>riempimento rado &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>Sparse infill</source>
        <translation>Riempimento rado</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Ponte</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Nastro</translation>
    </message>
    <message>
        <source>tapes after every n-th layer</source>
        <translation>nastri dopo ogni n-esimo strato</translation>
    </message>
    <message>
        <source>Irons tapes of continuous fibre onto every n-th layer but the last; needs a tool for tape. 0: no tapes.</source>
        <translation>Stira nastri di fibra continua su ogni n-esimo strato tranne l&apos;ultimo; richiede un utensile per nastro. 0: nessun nastro.</translation>
    </message>
    <message>
        <source>first layer with tapes</source>
        <translation>primo strato con nastri</translation>
    </message>
    <message>
        <source>Layers are counted from 1, on the platform.</source>
        <translation>Gli strati si contano da 1, sulla piattaforma.</translation>
    </message>
    <message>
        <source>tapes on a layer</source>
        <translation>nastri per strato</translation>
    </message>
    <message>
        <source>Only the longest tapes of each layer are laid. 0: as many as fit.</source>
        <translation>Si posano solo i nastri più lunghi di ogni strato. 0: quanti ne entrano.</translation>
    </message>
    <message>
        <source>paths of tapes</source>
        <translation>percorsi dei nastri</translation>
    </message>
    <message>
        <source>Tapes lie beside each other, one width apart.</source>
        <translation>I nastri sono affiancati, alla distanza di una larghezza.</translation>
    </message>
    <message>
        <source>direction of tapes</source>
        <translation>direzione dei nastri</translation>
    </message>
    <message>
        <source>Direction of tapes on the first layer with tapes, measured from x to y.</source>
        <translation>Direzione dei nastri sul primo strato con nastri, misurata da x verso y.</translation>
    </message>
    <message>
        <source>rotation of tapes per layer</source>
        <translation>rotazione dei nastri per strato</translation>
    </message>
    <message>
        <source>Rotation from one layer with tapes to the next.</source>
        <translation>Rotazione da uno strato con nastri al successivo.</translation>
    </message>
    <message>
        <source>distance of tape ends</source>
        <translation>distanza delle estremità dei nastri</translation>
    </message>
    <message>
        <source>Least distance of the ends of tapes from the outline, so that plastic encloses them. The sides are inside the outline.</source>
        <translation>Distanza minima delle estremità dei nastri dal contorno, affinché la plastica le racchiuda. I lati sono dentro il contorno.</translation>
    </message>
    <message>
        <source>curves for tapes</source>
        <translation>curve per i nastri</translation>
    </message>
    <message>
        <source>For tapes along given curves: points x,y or x,y,z in mm on the plate, separated by spaces, and semicolons between curves; or a file of them.</source>
        <translation>Per nastri lungo curve date: punti x,y oppure x,y,z in mm sul piano, separati da spazi, e punto e virgola tra le curve; o un file.</translation>
    </message>
    <message>
        <source>Fibre</source>
        <translation>Fibra</translation>
    </message>
    <message>
        <source>along a field of directions</source>
        <translation>lungo un campo di direzioni</translation>
    </message>
    <message>
        <source>there is no field of directions for tapes</source>
        <translation>manca un campo di direzioni per i nastri</translation>
    </message>
    <message>
        <source>give place and direction as x,y,z,dx,dy,dz, separated by spaces or lines</source>
        <translation>indica posizione e direzione come x,y,z,dx,dy,dz, separati da spazi o righe</translation>
    </message>
    <message>
        <source>&apos;{part}&apos; is no direction at a place</source>
        <translation>&apos;{part}&apos; non è una direzione in un punto</translation>
    </message>
    <message>
        <source>field of tape directions</source>
        <translation>campo di direzioni dei nastri</translation>
    </message>
    <message>
        <source>For tapes along a field: x,y,z,dx,dy,dz in mm on the plate, separated by spaces or lines, or a file of them.</source>
        <translation>Per nastri lungo un campo: x,y,z,dx,dy,dz in mm sul piano, separati da spazi o righe, o un file.</translation>
    </message>
    <message>
        <source>in one direction</source>
        <translation>in una direzione</translation>
    </message>
    <message>
        <source>along the outline</source>
        <translation>lungo il contorno</translation>
    </message>
    <message>
        <source>along given curves</source>
        <translation>lungo curve date</translation>
    </message>
    <message>
        <source>unknown paths of tapes &apos;{id}&apos;</source>
        <translation>percorsi dei nastri &apos;{id}&apos; sconosciuti</translation>
    </message>
    <message>
        <source>give points in mm: x,y or x,y,z, separated by spaces, at least two for each curve, and semicolons between curves</source>
        <translation>indica punti in mm: x,y oppure x,y,z, separati da spazi, almeno due per curva, e punto e virgola tra le curve</translation>
    </message>
    <message>
        <source>no tool of the job lays tape</source>
        <translation>nessun utensile del lavoro posa nastro</translation>
    </message>
    <message>
        <source>add a tool with a process for tape, such as tape-5, or set `fibreLayers=0`</source>
        <translation>aggiungi un utensile con un processo per nastro, come tape-5, oppure imposta `fibreLayers=0`</translation>
    </message>
    <message>
        <source>process {process} lays tape and prints no beads</source>
        <translation>il processo {process} posa nastro e non stampa cordoni</translation>
    </message>
    <message>
        <source>choose it for a further tool, and another one for the part</source>
        <translation>sceglilo per un altro utensile, e un altro processo per il pezzo</translation>
    </message>
    <message>
        <source>no tape fits into the layers chosen for tapes: {width} wide and at least {length:.0f} long</source>
        <translation>nessun nastro entra negli strati scelti per i nastri: largo {width} e lungo almeno {length:.0f}</translation>
    </message>
    <message>
        <source>choose another direction (`fibreAngle`), other paths (`fibrePaths`), or a narrower tape</source>
        <translation>scegli un&apos;altra direzione (`fibreAngle`), altri percorsi (`fibrePaths`) o un nastro più stretto</translation>
    </message>
    <message>
        <source>{bent:.0f} of tape is left out because it bends more than a radius of {radius:.0f} allows, {short:.0f} because its pieces are shorter than {length:.0f}</source>
        <translation>{bent:.0f} di nastro sono omessi perché piegano più di quanto consenta un raggio di {radius:.0f}, {short:.0f} perché i pezzi sono più corti di {length:.0f}</translation>
    </message>
    <message>
        <source>choose another direction (`fibreAngle`) or other paths (`fibrePaths`)</source>
        <translation>scegli un&apos;altra direzione (`fibreAngle`) o altri percorsi (`fibrePaths`)</translation>
    </message>
    <message>
        <source>plastic does not cover the tape: {length:.0f} on layer {layer}, from this place on</source>
        <translation>la plastica non copre il nastro: {length:.0f} sullo strato {layer}, da questo punto in poi</translation>
    </message>
    <message>
        <source>increase `fibreEndMm`, or choose layers that others cover (`fibreLayers`, `fibreFirstLayer`)</source>
        <translation>aumenta `fibreEndMm`, oppure scegli strati che altri coprono (`fibreLayers`, `fibreFirstLayer`)</translation>
    </message>
    <message>
        <source>is not less than &apos;widthMm&apos;</source>
        <translation>non è minore di &apos;widthMm&apos;</translation>
    </message>
    <message>
        <source>is less than half of &apos;widthMm&apos;</source>
        <translation>è minore della metà di &apos;widthMm&apos;</translation>
    </message>
    <message>
        <source>is not less than &apos;leastLengthMm&apos;</source>
        <translation>non è minore di &apos;leastLengthMm&apos;</translation>
    </message>
    <message numerus="yes">
        <source>the skins above a hollow interior have nothing to rest on: {paths} beads, from this place on</source>
        <translation>
            <numerusform>la pelle sopra un interno vuoto non ha appoggio: {paths} cordone, da questo punto in poi</numerusform>
            <numerusform>le pelli sopra un interno vuoto non hanno appoggio: {paths} cordoni, da questo punto in poi</numerusform>
        </translation>
    </message>
    <message>
        <source>set `infillDensity` to 0.1 or more; for a part that is open at the top, set `topLayers` to 0</source>
        <translation>imposta `infillDensity` a 0.1 o più; per un pezzo aperto in alto, imposta `topLayers` a 0</translation>
    </message>
    <message>
        <source>thin walls</source>
        <translation>pareti sottili</translation>
    </message>
    <message>
        <source>as the narrowest bead</source>
        <translation>come il cordone più stretto</translation>
    </message>
    <message>
        <source>leave out</source>
        <translation>ometti</translation>
    </message>
    <message>
        <source>Walls narrower than the narrowest bead: printed as that bead, and so too wide, or left out. Below half its width they are always left out.</source>
        <translation>Pareti più strette del cordone più stretto: stampate come quel cordone, quindi troppo larghe, oppure omesse. Sotto la metà della sua larghezza sono sempre omesse.</translation>
    </message>
    <message>
        <source>{length:.0f} of walls, down to {width:.2f} thin, is printed too wide: with the narrowest bead, {bead:.3g}</source>
        <translation>{length:.0f} di pareti, sottili fino a {width:.2f}, è stampato troppo largo: con il cordone più stretto, {bead:.3g}</translation>
    </message>
    <message>
        <source>use a finer nozzle, or leave them out (`thinWalls=omit`)</source>
        <translation>usa un ugello più fine, oppure omettile (`thinWalls=omit`)</translation>
    </message>
    <message>
        <source>{length:.0f} of walls, down to {width:.2f} thin, is left out: the narrowest bead is {bead:.3g}</source>
        <translation>{length:.0f} di pareti, sottili fino a {width:.2f}, è omesso: il cordone più stretto è {bead:.3g}</translation>
    </message>
    <message>
        <source>use a finer nozzle, or print them with that bead (`thinWalls=bead`)</source>
        <translation>usa un ugello più fine, oppure stampale con quel cordone (`thinWalls=bead`)</translation>
    </message>
    <message>
        <source>use thinner layers, or a part with steeper walls; another spiral may begin there</source>
        <translation>usa strati più sottili o un pezzo con pareti più ripide; lì può cominciare un&apos;altra spirale</translation>
    </message>
    <message>
        <source>the spiral ends below layer {layer} of {layers}, which does not continue the layer before</source>
        <translation>la spirale finisce sotto lo strato {layer} di {layers}, che non prosegue lo strato precedente</translation>
    </message>
    <message>
        <source>print towers as separate items, or cut off the part there; layers of several beads are printed as usual</source>
        <translation>stampa le torri come oggetti separati o taglia lì il pezzo; gli strati con più cordoni sono stampati come al solito</translation>
    </message>
    <message numerus="yes">
        <source>the spiral ends below layer {layer} of {layers}: it has {beads} beads, not one closed loop</source>
        <translation>
            <numerusform>la spirale finisce sotto lo strato {layer} di {layers}: il suo {beads} cordone non è un anello chiuso</numerusform>
            <numerusform>la spirale finisce sotto lo strato {layer} di {layers}: ha {beads} cordoni, non un unico anello chiuso</numerusform>
        </translation>
    </message>
    <message>
        <source>{first} and {second} overlap</source>
        <translation>{first} e {second} si sovrappongono</translation>
    </message>
    <message>
        <source>arrange the parts</source>
        <translation>disponi i pezzi</translation>
    </message>
    <message>
        <source>move one of the parts on the Prepare page, or arrange them</source>
        <translation>sposta uno dei pezzi nella pagina Prepara, oppure disponili</translation>
    </message>
    <message>
        <source>the head may touch {first} or {second} beside the other one: they are {gap:.1f} apart, the head needs {needed:.1f}</source>
        <translation>la testa può toccare {first} o {second} accanto all&apos;altro: distano {gap:.1f}, alla testa serve {needed:.1f}</translation>
    </message>
    <message>
        <source>{share:.2g} of {first} cannot be printed layer by layer: its layers tilt the head into {second}</source>
        <translation>{share:.2g} di {first} non si può stampare strato per strato: i suoi strati inclinano la testa contro {second}</translation>
    </message>
    <message>
        <source>move one of the parts on the Prepare page, or print one after another</source>
        <translation>sposta uno dei pezzi nella pagina Prepara, o stampali uno dopo l&apos;altro</translation>
    </message>
    <message>
        <source>print one after another, or move {second} by {move:.0f}</source>
        <translation>stampa i pezzi uno dopo l&apos;altro, o sposta {second} di {move:.0f}</translation>
    </message>
    <message>
        <source>print one after another</source>
        <translation>stampa i pezzi uno dopo l&apos;altro</translation>
    </message>
    <message>
        <source>move {second} by {move:.0f}</source>
        <translation>sposta {second} di {move:.0f}</translation>
    </message>
    <message>
        <source>print them as separate jobs</source>
        <translation>stampali in lavori separati</translation>
    </message>
    <message>
        <source>the flange carries {carried:.3g} kg, {material:.3g} kg of it printed material; the robot is rated for {most:.3g} kg</source>
        <translation>la flangia porta {carried:.3g} kg, di cui {material:.3g} kg di materiale stampato; il robot ha una portata di {most:.3g} kg</translation>
    </message>
    <message>
        <source>print a smaller part, or with less infill, or use a stronger robot</source>
        <translation>stampa un pezzo più piccolo o con meno riempimento, o usa un robot più forte</translation>
    </message>
    <message>
        <source>choose a cell with a stronger robot on the Prepare page</source>
        <translation>scegli una cella con un robot più forte nella pagina Prepara</translation>
    </message>
    <message>
        <source>is above {limit:.0f}</source>
        <translation>supera {limit:.0f}</translation>
    </message>
    <message>
        <source>is longer than maxLayerTimeS</source>
        <translation>è più lungo di maxLayerTimeS</translation>
    </message>
    <message>
        <source>`maxLayerTimeS={greatest:.0f}` is shorter than the {least:.0f} that {material} has to cool</source>
        <translation>`maxLayerTimeS={greatest:.0f}` è più breve dei {least:.0f} di raffreddamento di {material}</translation>
    </message>
    <message>
        <source>`minLayerTimeS={least:.0f}` is longer than the {greatest:.0f} in which {material} bonds</source>
        <translation>`minLayerTimeS={least:.0f}` è più lungo dei {greatest:.0f} entro cui {material} aderisce</translation>
    </message>
    <message>
        <source>give a longer maximum, or another material</source>
        <translation>indica un massimo più lungo, o un altro materiale</translation>
    </message>
    <message>
        <source>give a shorter minimum, or another material</source>
        <translation>indica un minimo più breve, o un altro materiale</translation>
    </message>
    <message>
        <source>arrange the parts, or print them layer by layer</source>
        <translation>disponi i pezzi, oppure stampali strato per strato</translation>
    </message>
    <message>
        <source>Print layer by layer</source>
        <translation>Stampa strato per strato</translation>
    </message>
    <message>
        <source>All parts grow together, so that no finished part is in the way</source>
        <translation>Tutti i pezzi crescono insieme, così nessun pezzo finito è d&apos;intralcio</translation>
    </message>
    <message>
        <source>the plate has no room for {parts} parts</source>
        <translation>il piano non ha posto per {parts} pezzi</translation>
    </message>
    <message>
        <source>print fewer or smaller parts, or use a cell with a larger plate</source>
        <translation>stampa meno pezzi o pezzi più piccoli, oppure usa una cella con un piano più grande</translation>
    </message>
    <message>
        <source>a spiral is printed alone</source>
        <translation>una spirale si stampa da sola</translation>
    </message>
    <message>
        <source>remove the other parts, or set spiral to false</source>
        <translation>togli gli altri pezzi, oppure imposta spiral su false</translation>
    </message>
    <message>
        <source>a part around a rod or on a body is printed alone</source>
        <translation>un pezzo attorno a un&apos;asta o su un corpo si stampa da solo</translation>
    </message>
    <message>
        <source>remove the other parts, or choose a way of building on a plate</source>
        <translation>togli gli altri pezzi, oppure scegli un modo di costruire su un piano</translation>
    </message>
    <message>
        <source>{parts} parts are too many for a job</source>
        <translation>{parts} pezzi sono troppi per un lavoro</translation>
    </message>
    <message>
        <source>print up to {most} parts</source>
        <translation>stampa al massimo {most} pezzi</translation>
    </message>
    <message>
        <source>a part on a ground of its own is printed alone</source>
        <translation>un pezzo su una base propria si stampa da solo</translation>
    </message>
    <message>
        <source>remove the other parts, or give `pathsOn=plate`</source>
        <translation>togli gli altri pezzi, oppure indica `pathsOn=plate`</translation>
    </message>
    <message>
        <source>different for each part</source>
        <translation>diverso per ogni pezzo</translation>
    </message>
    <message>
        <source>the bed temperature, °C</source>
        <translation>la temperatura del piatto, °C</translation>
    </message>
    <message>
        <source>a wait until the bed is hot</source>
        <translation>un&apos;attesa finché il piatto è caldo</translation>
    </message>
    <message>
        <source>must be at most {most}</source>
        <translation>deve essere al massimo {most}</translation>
    </message>
    <message>
        <source>must be one line that is not empty</source>
        <translation>deve essere una sola riga non vuota</translation>
    </message>
    <message>
        <source>has no statements</source>
        <translation>non ha istruzioni</translation>
    </message>
    <message>
        <source>has its statements already</source>
        <translation>ha già le sue istruzioni</translation>
    </message>
    <message>
        <source>must be between {least} and 1</source>
        <translation>deve essere tra {least} e 1</translation>
    </message>
    <message>
        <source>a wait for the extruder&apos;s start lag</source>
        <translation>un&apos;attesa per il ritardo d&apos;avvio dell&apos;estrusore</translation>
    </message>
    <message>
        <source>stopping the extruder ahead of a bead&apos;s end</source>
        <translation>l&apos;arresto dell&apos;estrusore prima della fine di un cordone</translation>
    </message>
    <message>
        <source>extruder {extruder} cannot keep the start and stop lag of process {process}</source>
        <translation>l&apos;estrusore {extruder} non può rispettare i ritardi d&apos;avvio e d&apos;arresto del processo {process}</translation>
    </message>
    <message>
        <source>turning off the nozzle&apos;s heating</source>
        <translation>lo spegnimento del riscaldamento dell&apos;ugello</translation>
    </message>
    <message>
        <source>turning off the bed&apos;s heating</source>
        <translation>lo spegnimento del riscaldamento del piatto</translation>
    </message>
    <message>
        <source>part cooling {found} % from this line on, {planned} % planned</source>
        <translation>raffreddamento del pezzo {found} % da questa riga in poi, previsto {planned} %</translation>
    </message>
    <message>
        <source>is above 250</source>
        <translation>è oltre 250</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; cannot be a material&apos;s id</source>
        <translation>&apos;{id}&apos; non può essere l&apos;id di un materiale</translation>
    </message>
    <message>
        <source>use small letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;</source>
        <translation>usa lettere minuscole, cifre, &apos;-&apos;, &apos;_&apos; e &apos;.&apos;</translation>
    </message>
    <message>
        <source>a material &apos;{id}&apos; comes with the program</source>
        <translation>un materiale &apos;{id}&apos; è fornito con il programma</translation>
    </message>
    <message>
        <source>choose another id</source>
        <translation>scegli un altro id</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Raffreddamento</translation>
    </message>
    <message>
        <source>minimum layer time</source>
        <translation>tempo minimo per strato</translation>
    </message>
    <message>
        <source>Minimum time before a bead is covered by the next layer, at every place. The robot waits above the part where the order of the beads does not give them this time. 0: no limit.</source>
        <translation>Tempo minimo prima che un cordone venga coperto dallo strato successivo, in ogni punto. Il robot attende sopra il pezzo dove l&apos;ordine dei cordoni non concede loro questo tempo. 0: nessun limite.</translation>
    </message>
    <message>
        <source>maximum layer time</source>
        <translation>tempo massimo per strato</translation>
    </message>
    <message>
        <source>Age up to which a bead still bonds with the one above it. Older places are reported. 0: no limit.</source>
        <translation>Età fino alla quale un cordone aderisce ancora a quello sopra di esso. I punti più vecchi vengono segnalati. 0: nessun limite.</translation>
    </message>
    <message>
        <source>a wait</source>
        <translation>un&apos;attesa</translation>
    </message>
    <message>
        <source>lower the minimum layer time, print slower, or print without a spiral</source>
        <translation>riduci il tempo minimo per strato, stampa più lentamente, o stampa senza spirale</translation>
    </message>
    <message>
        <source>only you know how long a bead has to cool: change the minimum layer time</source>
        <translation>solo tu sai quanto deve raffreddarsi un cordone: cambia il tempo minimo per strato</translation>
    </message>
    <message>
        <source>the bead below is {time:.1f} old when it is covered, beyond the maximum layer time of {limit:.1f}; so are {length:.0f} of beads</source>
        <translation>il cordone sottostante ha {time:.1f} quando viene coperto, oltre il tempo massimo per strato di {limit:.1f}; così {length:.0f} di cordoni</translation>
    </message>
    <message>
        <source>print faster, or fewer parts at a time</source>
        <translation>stampa più velocemente, o meno pezzi alla volta</translation>
    </message>
    <message>
        <source>Time between layers: {shortest:.1f} to {longest:.1f} on its controller, {mean:.1f} on average; at least {limit:.0f} required.</source>
        <translation>Tempo tra gli strati: da {shortest:.1f} a {longest:.1f} sul suo controllore, {mean:.1f} in media; richiesti almeno {limit:.0f}.</translation>
    </message>
    <message>
        <source>Layer time</source>
        <translation>Tempo per strato</translation>
    </message>
    <message>
        <source>slowest speed for cooling</source>
        <translation>velocità minima per il raffreddamento</translation>
    </message>
    <message>
        <source>Down to this speed beads are printed slower to keep the minimum layer time, before the robot waits. 0: it only waits.</source>
        <translation>Fino a questa velocità i cordoni vengono stampati più lentamente per rispettare il tempo minimo per strato, prima che il robot attenda. 0: attende soltanto.</translation>
    </message>
    <message>
        <source>Time between layers: {shortest:.1f} to {longest:.1f} on its controller, {mean:.1f} on average.</source>
        <translation>Tempo tra gli strati: da {shortest:.1f} a {longest:.1f} sul suo controllore, {mean:.1f} in media.</translation>
    </message>
    <message>
        <source>`minLayerTimeS={least:.0f}` is longer than `maxLayerTimeS={greatest:.0f}`</source>
        <translation>`minLayerTimeS={least:.0f}` è più lungo di `maxLayerTimeS={greatest:.0f}`</translation>
    </message>
    <message>
        <source>give a shorter minimum, or a longer maximum</source>
        <translation>indica un minimo più breve, o un massimo più lungo</translation>
    </message>
    <message>
        <source>#RRGGBB, for the view.</source>
        <translation>#RRGGBB, per la vista.</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; cannot be a process&apos;s id</source>
        <translation>«{id}» non può essere l&apos;identificativo di un processo</translation>
    </message>
    <message>
        <source>0: as in the process.</source>
        <translation>0: come nel processo.</translation>
    </message>
    <message>
        <source>Beads are nowhere narrower.</source>
        <translation>Nessun cordone è più stretto.</translation>
    </message>
    <message>
        <source>Beads are nowhere wider.</source>
        <translation>Nessun cordone è più largo.</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>Ponti</translation>
    </message>
    <message>
        <source>Colder nozzles do not print it.</source>
        <translation>Un ugello più freddo non lo stampa.</translation>
    </message>
    <message>
        <source>Curved layers are nowhere thicker.</source>
        <translation>Gli strati curvi non sono mai più spessi.</translation>
    </message>
    <message>
        <source>Curved layers are nowhere thinner.</source>
        <translation>Gli strati curvi non sono mai più sottili.</translation>
    </message>
    <message>
        <source>Density of the printed material.</source>
        <translation>Densità del materiale stampato.</translation>
    </message>
    <message>
        <source>Diameter of the nozzle&apos;s opening.</source>
        <translation>Diametro del foro dell&apos;ugello.</translation>
    </message>
    <message>
        <source>Distance of waypoints along a tool-path.</source>
        <translation>Distanza dei punti lungo un percorso utensile.</translation>
    </message>
    <message>
        <source>Extruder</source>
        <translation>Estrusore</translation>
    </message>
    <message>
        <source>Factor of the bead&apos;s section.</source>
        <translation>Fattore della sezione del cordone.</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Elementi</translation>
    </message>
    <message>
        <source>Flow at full scale of the analogue output.</source>
        <translation>Portata al fondo scala dell&apos;uscita analogica.</translation>
    </message>
    <message>
        <source>For people, for example how to dry it.</source>
        <translation>Per chi legge, per esempio come asciugarlo.</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Testina</translation>
    </message>
    <message>
        <source>Height and radius of its sections, in mm.</source>
        <translation>Altezza e raggio delle sue sezioni, in mm.</translation>
    </message>
    <message>
        <source>Hotter nozzles damage it.</source>
        <translation>Un ugello più caldo lo rovina.</translation>
    </message>
    <message>
        <source>How deep the head may enter soft beads before it is a collision.</source>
        <translation>Quanto la testina può entrare nei cordoni molli prima che sia una collisione.</translation>
    </message>
    <message>
        <source>In your currency. 0: unknown.</source>
        <translation>Nella propria valuta. 0: sconosciuto.</translation>
    </message>
    <message>
        <source>Length of filament that is retracted for a travel. 0: none.</source>
        <translation>Filamento ritratto per uno spostamento. 0: nessuno.</translation>
    </message>
    <message>
        <source>Length that a bead bridges, unless the process states it.</source>
        <translation>Lunghezza che un cordone supera a ponte, se il processo non la indica.</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limiti</translation>
    </message>
    <message>
        <source>Material that the process prints.</source>
        <translation>Materiale stampato dal processo.</translation>
    </message>
    <message>
        <source>Maximum acceleration of the nozzle.</source>
        <translation>Accelerazione massima dell&apos;ugello.</translation>
    </message>
    <message>
        <source>Maximum length of an unsupported bridge.</source>
        <translation>Lunghezza massima di un ponte senza sostegno.</translation>
    </message>
    <message>
        <source>Maximum speed on a bridge.</source>
        <translation>Velocità massima su un ponte.</translation>
    </message>
    <message>
        <source>Melted at most, whatever the process allows.</source>
        <translation>Quanto se ne fonde al massimo, qualunque cosa consenta il processo.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Altro</translation>
    </message>
    <message>
        <source>Part cooling from the second layer on, 0 to 1.</source>
        <translation>Raffreddamento del pezzo dal secondo strato in poi, da 0 a 1.</translation>
    </message>
    <message>
        <source>Part cooling of bridges, 0 to 1.</source>
        <translation>Raffreddamento dei ponti, da 0 a 1.</translation>
    </message>
    <message>
        <source>Shown in lists and reports.</source>
        <translation>Mostrato in elenchi e rapporti.</translation>
    </message>
    <message>
        <source>Speed of the nozzle between tool-paths.</source>
        <translation>Velocità dell&apos;ugello fra i percorsi.</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>Velocità</translation>
    </message>
    <message>
        <source>Temperatures</source>
        <translation>Temperature</translation>
    </message>
    <message>
        <source>The extruder runs this long before a tool-path begins.</source>
        <translation>L&apos;estrusore gira per questo tempo prima che un percorso cominci.</translation>
    </message>
    <message>
        <source>Usual height of a layer, and of a bead.</source>
        <translation>Altezza abituale di uno strato e di un cordone.</translation>
    </message>
    <message>
        <source>Usual speed of the nozzle while it prints.</source>
        <translation>Velocità abituale dell&apos;ugello mentre stampa.</translation>
    </message>
    <message>
        <source>Usual temperature of the nozzle.</source>
        <translation>Temperatura abituale dell&apos;ugello.</translation>
    </message>
    <message>
        <source>Usual temperature of the plate.</source>
        <translation>Temperatura abituale del piatto.</translation>
    </message>
    <message>
        <source>Usual width of a bead.</source>
        <translation>Larghezza abituale di un cordone.</translation>
    </message>
    <message>
        <source>Whatever the process allows.</source>
        <translation>Qualunque cosa consenta il processo.</translation>
    </message>
    <message>
        <source>a process &apos;{id}&apos; comes with the program</source>
        <translation>un processo «{id}» è già fornito con il programma</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>accelerazione</translation>
    </message>
    <message>
        <source>any</source>
        <translation>qualsiasi</translation>
    </message>
    <message>
        <source>as elsewhere</source>
        <translation>come altrove</translation>
    </message>
    <message>
        <source>as in the process</source>
        <translation>come nel processo</translation>
    </message>
    <message>
        <source>block height</source>
        <translation>altezza del blocco</translation>
    </message>
    <message>
        <source>block width</source>
        <translation>larghezza del blocco</translation>
    </message>
    <message>
        <source>bridge flow</source>
        <translation>flusso dei ponti</translation>
    </message>
    <message>
        <source>bridge length in bead widths</source>
        <translation>lunghezza dei ponti in larghezze di cordone</translation>
    </message>
    <message>
        <source>bridge speed</source>
        <translation>velocità dei ponti</translation>
    </message>
    <message>
        <source>cannot be deleted</source>
        <translation>non può essere cancellato</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>colore</translation>
    </message>
    <message>
        <source>cone angle</source>
        <translation>angolo del cono</translation>
    </message>
    <message>
        <source>cone angle must be below 180°</source>
        <translation>l&apos;angolo del cono deve essere minore di 180°</translation>
    </message>
    <message>
        <source>cone height</source>
        <translation>altezza del cono</translation>
    </message>
    <message>
        <source>contact tolerance</source>
        <translation>tolleranza di contatto</translation>
    </message>
    <message>
        <source>density</source>
        <translation>densità</translation>
    </message>
    <message>
        <source>export the head with its nozzle pointing down</source>
        <translation>esporta la testina con l&apos;ugello verso il basso</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>ventola</translation>
    </message>
    <message>
        <source>fan on bridges</source>
        <translation>ventola sui ponti</translation>
    </message>
    <message>
        <source>first-layer flow</source>
        <translation>flusso del primo strato</translation>
    </message>
    <message>
        <source>first-layer width</source>
        <translation>larghezza del primo strato</translation>
    </message>
    <message>
        <source>infill flow</source>
        <translation>flusso del riempimento</translation>
    </message>
    <message>
        <source>inner-wall flow</source>
        <translation>flusso delle pareti interne</translation>
    </message>
    <message>
        <source>is above 1000</source>
        <translation>è oltre 1000</translation>
    </message>
    <message>
        <source>is above 30 g/cm3: check the unit</source>
        <translation>è oltre 30 g/cm3: controlla l&apos;unità</translation>
    </message>
    <message>
        <source>is above {most} {unit}: check the unit</source>
        <translation>è oltre {most} {unit}: controlla l&apos;unità</translation>
    </message>
    <message>
        <source>is below 1</source>
        <translation>è minore di 1</translation>
    </message>
    <message>
        <source>is {usual}, above &apos;max&apos;, which is {most}</source>
        <translation>è {usual}, oltre &apos;max&apos;, che è {most}</translation>
    </message>
    <message>
        <source>is {usual}, below &apos;min&apos;, which is {least}</source>
        <translation>è {usual}, sotto &apos;min&apos;, che è {least}</translation>
    </message>
    <message>
        <source>label</source>
        <translation>etichetta</translation>
    </message>
    <message>
        <source>longest bridge</source>
        <translation>ponte più lungo</translation>
    </message>
    <message>
        <source>material</source>
        <translation>materiale</translation>
    </message>
    <message>
        <source>maximum bead width</source>
        <translation>larghezza massima del cordone</translation>
    </message>
    <message>
        <source>maximum flow</source>
        <translation>portata massima</translation>
    </message>
    <message>
        <source>maximum layer height</source>
        <translation>altezza massima dello strato</translation>
    </message>
    <message>
        <source>maximum nozzle temperature</source>
        <translation>temperatura massima dell&apos;ugello</translation>
    </message>
    <message>
        <source>minimum bead width</source>
        <translation>larghezza minima del cordone</translation>
    </message>
    <message>
        <source>minimum layer height</source>
        <translation>altezza minima dello strato</translation>
    </message>
    <message>
        <source>minimum nozzle temperature</source>
        <translation>temperatura minima dell&apos;ugello</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>non deve essere vuoto</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>note</translation>
    </message>
    <message>
        <source>nozzle diameter</source>
        <translation>diametro dell&apos;ugello</translation>
    </message>
    <message>
        <source>nozzle temperature</source>
        <translation>temperatura dell&apos;ugello</translation>
    </message>
    <message>
        <source>nozzle tip radius</source>
        <translation>raggio della punta dell&apos;ugello</translation>
    </message>
    <message>
        <source>outer-wall flow</source>
        <translation>flusso della parete esterna</translation>
    </message>
    <message>
        <source>outer-wall width</source>
        <translation>larghezza della parete esterna</translation>
    </message>
    <message>
        <source>plate temperature</source>
        <translation>temperatura del piatto</translation>
    </message>
    <message>
        <source>price per kg</source>
        <translation>prezzo al kg</translation>
    </message>
    <message>
        <source>prime time</source>
        <translation>tempo di innesco</translation>
    </message>
    <message>
        <source>print speed</source>
        <translation>velocità di stampa</translation>
    </message>
    <message>
        <source>reduce angle or height of the cone</source>
        <translation>riduci l&apos;angolo o l&apos;altezza del cono</translation>
    </message>
    <message>
        <source>retraction length</source>
        <translation>lunghezza di ritrazione</translation>
    </message>
    <message>
        <source>sparse-infill flow</source>
        <translation>flusso del riempimento rado</translation>
    </message>
    <message>
        <source>sparse-infill speed</source>
        <translation>velocità del riempimento rado</translation>
    </message>
    <message>
        <source>support flow</source>
        <translation>flusso dei supporti</translation>
    </message>
    <message>
        <source>support width</source>
        <translation>larghezza dei supporti</translation>
    </message>
    <message>
        <source>the cone is {cone} wide at its top, more than the block&apos;s corners, {block}</source>
        <translation>in cima il cono è largo {cone}, più degli spigoli del blocco, {block}</translation>
    </message>
    <message>
        <source>the mesh is flat: it has no height along z</source>
        <translation>la mesh è piatta: non ha altezza lungo z</translation>
    </message>
    <message>
        <source>travel speed</source>
        <translation>velocità di spostamento</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>sconosciuto</translation>
    </message>
    <message>
        <source>waypoint distance</source>
        <translation>distanza dei punti</translation>
    </message>
    <message>
        <source>{name} must be greater than 0</source>
        <translation>{name}: deve essere maggiore di 0</translation>
    </message>
    <message>
        <source>&apos;Pause&apos; does not wait for the motions before it (QueueTag)</source>
        <translation>&apos;Pause&apos; non aspetta i movimenti che la precedono (QueueTag)</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a list of tools</source>
        <translation>&apos;{text}&apos; non è un elenco di utensili</translation>
    </message>
    <message>
        <source>Material that flows out at the place of the tool change after each change of the tool.</source>
        <translation>Materiale che fuoriesce nel punto del cambio utensile dopo ogni cambio.</translation>
    </message>
    <message>
        <source>Mode planar: numbers of the tools that print the pieces, separated by commas. The list starts over if there are more pieces. Empty: the tool of the part.</source>
        <translation>Modo planar: numeri degli utensili che stampano i pezzi, separati da virgole. Si ricomincia dal primo se i pezzi sono di più. Vuoto: l&apos;utensile del pezzo.</translation>
    </message>
    <message>
        <source>Number of the tool that fills the interior within walls and skins; 0: that of the part.</source>
        <translation>Numero dell&apos;utensile che riempie l&apos;interno fra pareti e superfici; 0: quello del pezzo.</translation>
    </message>
    <message>
        <source>Number of the tool that prints supports; 0: that of the part.</source>
        <translation>Numero dell&apos;utensile che stampa i supporti; 0: quello del pezzo.</translation>
    </message>
    <message>
        <source>Number of the tool that prints the part. The tips of all tools are in one place, that of the cell&apos;s nozzle.</source>
        <translation>Numero dell&apos;utensile che stampa il pezzo. Le punte di tutti gli utensili sono in un solo punto, quello dell&apos;ugello della cella.</translation>
    </message>
    <message>
        <source>Tool changes</source>
        <translation>Cambi utensile</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Utensili</translation>
    </message>
    <message>
        <source>a purge of the nozzle</source>
        <translation>uno spurgo dell&apos;ugello</translation>
    </message>
    <message>
        <source>a tool is selected together with a command</source>
        <translation>un utensile è scelto insieme a un comando</translation>
    </message>
    <message>
        <source>add a tool, or give the number of one</source>
        <translation>aggiungi un utensile, o indica il numero di uno esistente</translation>
    </message>
    <message>
        <source>are those of a changer</source>
        <translation>sono quelli di un cambio utensile</translation>
    </message>
    <message>
        <source>cannot be changer: the nozzle does not move</source>
        <translation>non può essere changer: l&apos;ugello non si muove</translation>
    </message>
    <message>
        <source>cell {cell} has no dock for tool {tool}</source>
        <translation>la cella {cell} non ha una stazione per l&apos;utensile {tool}</translation>
    </message>
    <message>
        <source>give numbers, such as 1,2</source>
        <translation>indica dei numeri, come 1,2</translation>
    </message>
    <message>
        <source>give up to {most}</source>
        <translation>indicane al massimo {most}</translation>
    </message>
    <message>
        <source>locking the tool</source>
        <translation>il blocco dell&apos;utensile</translation>
    </message>
    <message>
        <source>the selection of the first tool</source>
        <translation>la scelta del primo utensile</translation>
    </message>
    <message>
        <source>the tool that the program begins with</source>
        <translation>l&apos;utensile con cui comincia il programma</translation>
    </message>
    <message>
        <source>before {event}</source>
        <translation>prima di: {event}</translation>
    </message>
    <message>
        <source>behind {event}</source>
        <translation>dopo: {event}</translation>
    </message>
    <message>
        <source>the time for {event}</source>
        <translation>il tempo per: {event}</translation>
    </message>
    <message>
        <source>the text of the stop</source>
        <translation>il testo dell&apos;arresto</translation>
    </message>
    <message>
        <source>a motion that begins with no tool</source>
        <translation>un movimento che comincia senza utensile</translation>
    </message>
    <message>
        <source>the output of a tool is not set: an earlier run may have left it on</source>
        <translation>l&apos;uscita di un utensile non è impostata: un&apos;esecuzione precedente può averla lasciata attiva</translation>
    </message>
    <message>
        <source>the arm does not get to the place for purges without a collision</source>
        <translation>il braccio non raggiunge senza collisioni il punto di spurgo</translation>
    </message>
    <message>
        <source>move the place or the part</source>
        <translation>sposta il punto o il pezzo</translation>
    </message>
    <message>
        <source>the nozzle does not move</source>
        <translation>l&apos;ugello non si muove</translation>
    </message>
    <message>
        <source>a prime or a purge of {volume:.0f} falls on the {body}</source>
        <translation>un innesco o uno spurgo di {volume:.0f} cade su: {body}</translation>
    </message>
    <message>
        <source>a prime or a purge of {volume:.0f} falls on the plate, beside the print</source>
        <translation>un innesco o uno spurgo di {volume:.0f} cade sul piano, accanto alla stampa</translation>
    </message>
    <message>
        <source>state a place for purges in the cell (purgeMm), or move the part</source>
        <translation>indica nella cella un punto di spurgo (purgeMm), oppure sposta il pezzo</translation>
    </message>
    <message>
        <source>remove the strand before it is dragged along, or state a place for purges in the cell (purgeMm)</source>
        <translation>togli il filo prima che venga trascinato, oppure indica nella cella un punto di spurgo (purgeMm)</translation>
    </message>
    <message>
        <source>print</source>
        <translation>stampa</translation>
    </message>
    <message>
        <source>workpiece</source>
        <translation>pezzo di base</translation>
    </message>
    <message>
        <source>the arm does not reach the place for purges</source>
        <translation>il braccio non raggiunge il punto di spurgo</translation>
    </message>
    <message>
        <source>the arm collides at the place for purges</source>
        <translation>il braccio urta nel punto di spurgo</translation>
    </message>
    <message>
        <source>move the place for purges</source>
        <translation>sposta il punto di spurgo</translation>
    </message>
    <message>
        <source>move the dock or the part</source>
        <translation>sposta la stazione o il pezzo</translation>
    </message>
    <message>
        <source>must be hand, feeder or changer</source>
        <translation>deve essere hand, feeder o changer</translation>
    </message>
    <message>
        <source>purge</source>
        <translation>spurgo</translation>
    </message>
    <message>
        <source>releasing the tool</source>
        <translation>il rilascio dell&apos;utensile</translation>
    </message>
    <message>
        <source>remove a tool, or choose another cell</source>
        <translation>togli un utensile, o scegli un&apos;altra cella</translation>
    </message>
    <message>
        <source>the arm does not get to the dock of tool {number} without a collision</source>
        <translation>il braccio non arriva alla stazione dell&apos;utensile {number} senza collisioni</translation>
    </message>
    <message>
        <source>the extruder {extruder} prints with one tool</source>
        <translation>l&apos;estrusore {extruder} stampa con un solo utensile</translation>
    </message>
    <message>
        <source>the job has no tool {number}, it has {tools}</source>
        <translation>il lavoro non ha l&apos;utensile {number}, ne ha {tools}</translation>
    </message>
    <message>
        <source>the outputs of several tools are on</source>
        <translation>le uscite di più utensili sono attive</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>utensile</translation>
    </message>
    <message>
        <source>tool {number} cannot print layers of {height}</source>
        <translation>l&apos;utensile {number} non può stampare strati di {height}</translation>
    </message>
    <message>
        <source>tool {number}: {material}, {process}, {mass:.1f} g</source>
        <translation>utensile {number}: {material}, {process}, {mass:.1f} g</translation>
    </message>
    <message>
        <source>tools of the pieces</source>
        <translation>utensili dei pezzi</translation>
    </message>
    <message>
        <source>{changes}, {mass:.1f} g purged</source>
        <translation>{changes}, {mass:.1f} g di spurgo</translation>
    </message>
    <message>
        <source>{tools} tools are too many for a job</source>
        <translation>{tools} utensili sono troppi per un lavoro</translation>
    </message>
    <message>
        <source>export it in millimetres</source>
        <translation>esportala in millimetri</translation>
    </message>
    <message>
        <source>the mesh is only {height} high</source>
        <translation>la mesh è alta solo {height}</translation>
    </message>
    <message>
        <source>Layer times</source>
        <translation>Tempi di strato</translation>
    </message>
    <message>
        <source>Time that a bead needs before the next layer covers it, unless the job states it.</source>
        <translation>Tempo che serve a un cordone prima che lo strato successivo lo copra, se il lavoro non lo indica.</translation>
    </message>
    <message>
        <source>Age up to which a bead bonds with the next layer, unless the job states it.</source>
        <translation>Età fino alla quale un cordone si lega allo strato successivo, se il lavoro non la indica.</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Iniezione</translation>
    </message>
    <message>
        <source>Stitches</source>
        <translation>Punti di cucitura</translation>
    </message>
    <message>
        <source>spacing of stitches</source>
        <translation>distanza dei punti di cucitura</translation>
    </message>
    <message>
        <source>Mode flat: distance of pockets that are filled from above in one shot and lock the layers together. 0: none.</source>
        <translation>Modalità piana: distanza delle tasche che vengono riempite dall&apos;alto con una sola iniezione e che vincolano gli strati fra loro. 0: nessuna.</translation>
    </message>
    <message>
        <source>diameter of stitches</source>
        <translation>diametro dei punti di cucitura</translation>
    </message>
    <message>
        <source>stitches after every n-th layer</source>
        <translation>punti di cucitura dopo ogni n-esimo strato</translation>
    </message>
    <message>
        <source>Pockets end at the top of these layers.</source>
        <translation>Le tasche terminano alla sommità di questi strati.</translation>
    </message>
    <message>
        <source>stitches need horizontal layers</source>
        <translation>i punti di cucitura richiedono strati orizzontali</translation>
    </message>
    <message>
        <source>set `stitchSpacing=0`, or give no `layerPlanes`</source>
        <translation>imposta `stitchSpacing=0`, o non indicare `layerPlanes`</translation>
    </message>
    <message>
        <source>excess of a shot</source>
        <translation>eccedenza di un&apos;iniezione</translation>
    </message>
    <message>
        <source>Material of a shot beyond the volume of its pocket, as a share of that volume.</source>
        <translation>Materiale di un&apos;iniezione oltre il volume della sua tasca, come frazione di quel volume.</translation>
    </message>
    <message>
        <source>nozzle depth of a shot</source>
        <translation>profondità dell&apos;ugello in un&apos;iniezione</translation>
    </message>
    <message>
        <source>Depth of the nozzle in the pocket; 0: it seals the opening.</source>
        <translation>Profondità dell&apos;ugello nella tasca; 0: ne chiude l&apos;apertura.</translation>
    </message>
    <message>
        <source>flow of a shot</source>
        <translation>portata di un&apos;iniezione</translation>
    </message>
    <message>
        <source>Flow into a pocket, at most that of the process. 0: as much.</source>
        <translation>Portata in una tasca, al massimo quella del processo. 0: altrettanta.</translation>
    </message>
    <message>
        <source>wait after a shot</source>
        <translation>attesa dopo un&apos;iniezione</translation>
    </message>
    <message>
        <source>Time that the nozzle stays in the pocket after the shot, so that the material does not come out again.</source>
        <translation>Tempo in cui l&apos;ugello resta nella tasca dopo l&apos;iniezione, affinché il materiale non ne riesca.</translation>
    </message>
    <message>
        <source>a shot into a pocket</source>
        <translation>un&apos;iniezione in una tasca</translation>
    </message>
    <message>
        <source>Trace on a surface</source>
        <translation>Tracciato su una superficie</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Tracciato</translation>
    </message>
    <message>
        <source>find the seam</source>
        <translation>ricerca della cucitura</translation>
    </message>
    <message>
        <source>the part has no surface within {angle} of the vertical that is wide enough for a seam</source>
        <translation>il pezzo non ha alcuna superficie entro {angle} dalla verticale che sia abbastanza larga per una cucitura</translation>
    </message>
    <message>
        <source>turn the part, or increase `traceAngle`</source>
        <translation>ruota il pezzo, o aumenta `traceAngle`</translation>
    </message>
    <message>
        <source>greatest angle of the traced surface</source>
        <translation>angolo massimo della superficie tracciata</translation>
    </message>
    <message>
        <source>Mode trace: the seam is the outline of the part&apos;s surface whose normal is within this angle of the vertical.</source>
        <translation>Modalità tracciato: la cucitura è il contorno della superficie del pezzo la cui normale è entro questo angolo dalla verticale.</translation>
    </message>
    <message>
        <source>inset of the seam</source>
        <translation>rientro della cucitura</translation>
    </message>
    <message>
        <source>Distance of the first bead from the outline, inwards, seen from above.</source>
        <translation>Distanza del primo cordone dal contorno, verso l&apos;interno, vista dall&apos;alto.</translation>
    </message>
    <message>
        <source>seams</source>
        <translation>cuciture</translation>
    </message>
    <message>
        <source>Number of beads from the outline inwards.</source>
        <translation>Numero di cordoni dal contorno verso l&apos;interno.</translation>
    </message>
    <message>
        <source>side passes</source>
        <translation>passate laterali</translation>
    </message>
    <message>
        <source>Number of beads on the side of the part, below the outline.</source>
        <translation>Numero di cordoni sul fianco del pezzo, sotto il contorno.</translation>
    </message>
    <message>
        <source>depth of side passes</source>
        <translation>profondità delle passate laterali</translation>
    </message>
    <message>
        <source>Height of the outline above the first side pass.</source>
        <translation>Altezza del contorno sopra la prima passata laterale.</translation>
    </message>
    <message>
        <source>lines at heel and toe</source>
        <translation>linee a tacco e punta</translation>
    </message>
    <message>
        <source>Number of parallel beads that fill each of the two ends inside the innermost seam.</source>
        <translation>Numero di cordoni paralleli che riempiono ciascuna delle due estremità dentro la cucitura più interna.</translation>
    </message>
    <message>
        <source>angle of lines</source>
        <translation>angolo delle linee</translation>
    </message>
    <message>
        <source>Angle of the lines at heel and toe to the x axis, seen from above.</source>
        <translation>Angolo delle linee a tacco e punta rispetto all&apos;asse x, visto dall&apos;alto.</translation>
    </message>
    <message>
        <source>dovetail</source>
        <translation>coda di rondine</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>cono</translation>
    </message>
    <message>
        <source>shape of stitches</source>
        <translation>forma dei punti</translation>
    </message>
    <message>
        <source>Dovetail: chamber, cone and opening, three quarters of the diameter high. Cone: half of the diameter high.</source>
        <translation>Coda di rondine: camera, cono e apertura, alta tre quarti del diametro. Cono: alto metà del diametro.</translation>
    </message>
    <message>
        <source>Diameter of a pocket where it is widest. Its opening is half of it wide.</source>
        <translation>Diametro di una tasca dove è più larga. La sua apertura è larga la metà.</translation>
    </message>
    <message>
        <source>process {process} has no statements (beadWords) for format {format}, which its beads need</source>
        <translation>il processo {process} non ha istruzioni (beadWords) per il formato {format}, di cui i suoi cordoni hanno bisogno</translation>
    </message>
    <message>
        <source>use {formats}, or add the statements to the process</source>
        <translation>usa {formats}, o aggiungi le istruzioni al processo</translation>
    </message>
    <message>
        <source>beadWords: &apos;{word}&apos; is not a word for a force</source>
        <translation>beadWords: &apos;{word}&apos; non è una parola per una forza</translation>
    </message>
    <message>
        <source>write {pressFrame}, {pressSpace}, {press 5} or {pressAxis 20}</source>
        <translation>scrivi {pressFrame}, {pressSpace}, {press 5} o {pressAxis 20}</translation>
    </message>
    <message>
        <source>the nozzle of cell {cell} is along no axis of the arm&apos;s base, so that MELFA cannot press along it</source>
        <translation>l&apos;ugello della cella {cell} non è lungo un asse della base del braccio, quindi MELFA non può premere lungo di esso</translation>
    </message>
    <message>
        <source>use a cell whose nozzle is upright, or another format</source>
        <translation>usa una cella il cui ugello è verticale, o un altro formato</translation>
    </message>
    <message>
        <source>find the skeleton</source>
        <translation>trova lo scheletro</translation>
    </message>
    <message>
        <source>pith</source>
        <translation>midollo</translation>
    </message>
    <message>
        <source>the part is not closed</source>
        <translation>il pezzo non è chiuso</translation>
    </message>
    <message>
        <source>the part has no limbs</source>
        <translation>il pezzo non ha rami</translation>
    </message>
    <message>
        <source>use infill that is dense along the part&apos;s middle (`sparsePattern=pith`)</source>
        <translation>usa un riempimento denso lungo il mezzo del pezzo (`sparsePattern=pith`)</translation>
    </message>
    <message>
        <source>the limbs of the pith cannot be joined</source>
        <translation>i rami del midollo non si possono unire</translation>
    </message>
    <message>
        <source>change the pith&apos;s share</source>
        <translation>cambia la quota del midollo</translation>
    </message>
    <message>
        <source>the pith cannot be cut at the part&apos;s surface</source>
        <translation>il midollo non si può tagliare alla superficie del pezzo</translation>
    </message>
    <message>
        <source>distance of seams</source>
        <translation>distanza delle cuciture</translation>
    </message>
    <message>
        <source>Distance between beads, seen from above. 0: the bead&apos;s width.</source>
        <translation>Distanza fra i cordoni, vista dall&apos;alto. 0: la larghezza del cordone.</translation>
    </message>
    <message>
        <source>radius of the outline&apos;s hull</source>
        <translation>raggio dell&apos;inviluppo del contorno</translation>
    </message>
    <message>
        <source>Gaps of the outline through which no disc of this radius passes are closed.</source>
        <translation>I vuoti del contorno attraverso cui non passa un disco di questo raggio vengono chiusi.</translation>
    </message>
    <message>
        <source>Hard plastic</source>
        <translation>Plastica dura</translation>
    </message>
    <message>
        <source>Soft plastic</source>
        <translation>Plastica morbida</translation>
    </message>
    <message>
        <source>the cutter has no diameter or no teeth</source>
        <translation>la fresa non ha diametro o non ha denti</translation>
    </message>
    <message>
        <source>give --cutter and --teeth above 0</source>
        <translation>indica --cutter e --teeth maggiori di 0</translation>
    </message>
    <message>
        <source>a distance of passes is not positive</source>
        <translation>una distanza fra le passate non è positiva</translation>
    </message>
    <message>
        <source>give distances above 0</source>
        <translation>indica distanze maggiori di 0</translation>
    </message>
    <message>
        <source>the block is less than the cutter&apos;s {diameter} wider than the part</source>
        <translation>il blocco supera il pezzo di meno dei {diameter} della fresa</translation>
    </message>
    <message>
        <source>increase --gap</source>
        <translation>aumenta --gap</translation>
    </message>
    <message>
        <source>unknown word {word}</source>
        <translation>parola {word} sconosciuta</translation>
    </message>
    <message>
        <source>a motion before {word}</source>
        <translation>un movimento prima di {word}</translation>
    </message>
    <message>
        <source>G53 with another position than Z0 is not understood</source>
        <translation>G53 con una posizione diversa da Z0 non è comprensibile</translation>
    </message>
    <message>
        <source>the block turns while the cutter is not home</source>
        <translation>il blocco ruota mentre la fresa non è in posizione di riferimento</translation>
    </message>
    <message>
        <source>the block is turned by neither 0 nor 180 degrees</source>
        <translation>il blocco non è ruotato né di 0 né di 180 gradi</translation>
    </message>
    <message>
        <source>coordinates of another side</source>
        <translation>coordinate di un altro lato</translation>
    </message>
    <message>
        <source>a rapid move through the block</source>
        <translation>un movimento rapido attraverso il blocco</translation>
    </message>
    <message>
        <source>the spindle has another speed than planned</source>
        <translation>il mandrino ha una velocità diversa da quella prevista</translation>
    </message>
    <message>
        <source>another feed than planned</source>
        <translation>un avanzamento diverso da quello previsto</translation>
    </message>
    <message>
        <source>{volume:.0f} of the block stay in slots, undercuts or holes that should be free, up to {height:.1f} high</source>
        <translation>{volume:.0f} del blocco restano in cave, sottosquadri o fori che dovrebbero essere liberi, alti fino a {height:.1f}</translation>
    </message>
    <message>
        <source>only you know which cutter and block you have: change the values of the passes</source>
        <translation>solo tu sai quale fresa e quale blocco hai: cambia i valori delle passate</translation>
    </message>
    <message>
        <source>the cutter takes up to {depth:.3f} from the part</source>
        <translation>la fresa asporta fino a {depth:.3f} dal pezzo</translation>
    </message>
    <message>
        <source>the way home</source>
        <translation>il ritorno a riposo</translation>
    </message>
    <message>
        <source>&apos;{place}&apos; is no place</source>
        <translation>&apos;{place}&apos; non è una posizione</translation>
    </message>
    <message>
        <source>give X,Y,Z in mm and a rotation about z in degrees, as in 900,0,0,180</source>
        <translation>indicare X,Y,Z in mm e una rotazione attorno a z in gradi, come in 900,0,0,180</translation>
    </message>
    <message>
        <source>the job has no motion</source>
        <translation>il lavoro non ha movimento</translation>
    </message>
    <message>
        <source>looking for an order of work</source>
        <translation>ricerca di un ordine di lavoro</translation>
    </message>
    <message>
        <source>{count} jobs: two to {most} machines can work together</source>
        <translation>{count} lavori: possono lavorare insieme da due a {most} macchine</translation>
    </message>
    <message>
        <source>machine {machine} waits in line {line} for a mark that the other does not reach</source>
        <translation>la macchina {machine} attende alla riga {line} un segnale che l&apos;altra non raggiunge</translation>
    </message>
    <message>
        <source>machine {machine} passes the mark in line {line} before machine {other} has reached it, if signals are still on or the programs are not started at once</source>
        <translation>la macchina {machine} supera il segnale alla riga {line} prima che la macchina {other} lo raggiunga, se vi sono segnali ancora attivi o i programmi non partono insieme</translation>
    </message>
    <message>
        <source>machine {machine}: {reason}</source>
        <translation>macchina {machine}: {reason}</translation>
    </message>
    <message>
        <source>name a folder that &apos;together&apos; wrote</source>
        <translation>indicare una cartella scritta da &apos;together&apos;</translation>
    </message>
    <message>
        <source>comparing the motions of the machines</source>
        <translation>confronto dei movimenti delle macchine</translation>
    </message>
    <message>
        <source>running all programs in one time</source>
        <translation>esecuzione di tutti i programmi nello stesso tempo</translation>
    </message>
    <message>
        <source>a mark for the other machine</source>
        <translation>un segnale per l&apos;altra macchina</translation>
    </message>
    <message>
        <source>an input is read while motions are queued</source>
        <translation>un ingresso viene letto mentre ci sono movimenti in coda</translation>
    </message>
    <message>
        <source>dense at the pith</source>
        <translation>denso al midollo</translation>
    </message>
    <message>
        <source>mean step height</source>
        <translation>altezza media dei gradini</translation>
    </message>
    <message>
        <source>Mean step
mm</source>
        <translation>Gradino
medio mm</translation>
    </message>
    <message>
        <source>greatest step height</source>
        <translation>altezza massima dei gradini</translation>
    </message>
    <message>
        <source>Greatest
step mm</source>
        <translation>Gradino
massimo mm</translation>
    </message>
    <message>
        <source>angle between beads and load</source>
        <translation>angolo tra cordoni e carico</translation>
    </message>
    <message>
        <source>Bead
angle °</source>
        <translation>Angolo
cordoni °</translation>
    </message>
    <message>
        <source>interfaces across the load</source>
        <translation>interfacce attraverso il carico</translation>
    </message>
    <message>
        <source>Inter-
faces %</source>
        <translation>Inter-
facce %</translation>
    </message>
    <message>
        <source>interfaces in the weakest section</source>
        <translation>interfacce nella sezione più debole</translation>
    </message>
    <message>
        <source>Weakest
% interf.</source>
        <translation>Più debole
% interf.</translation>
    </message>
    <message>
        <source>is below {least}</source>
        <translation>è inferiore a {least}</translation>
    </message>
    <message>
        <source>Sizes</source>
        <translation>Misure</translation>
    </message>
    <message>
        <source>size factor along x</source>
        <translation>fattore di misura lungo x</translation>
    </message>
    <message>
        <source>Flat layers are made larger by it, so that printed lengths are right. 1: none.</source>
        <translation>Ingrandisce gli strati piani, così che le lunghezze stampate siano giuste. 1: nessuno.</translation>
    </message>
    <message>
        <source>size factor along y</source>
        <translation>fattore di misura lungo y</translation>
    </message>
    <message>
        <source>As along x.</source>
        <translation>Come lungo x.</translation>
    </message>
    <message>
        <source>outline offset</source>
        <translation>scostamento del contorno</translation>
    </message>
    <message>
        <source>Outlines of flat layers move outwards by it.</source>
        <translation>Di tanto i contorni degli strati piani si spostano verso l&apos;esterno.</translation>
    </message>
    <message>
        <source>hole offset</source>
        <translation>scostamento dei fori</translation>
    </message>
    <message>
        <source>Contours of holes in flat layers move into the material by it.</source>
        <translation>Di tanto i contorni dei fori negli strati piani si spostano nel materiale.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Resistenza</translation>
    </message>
    <message>
        <source>direction of the load</source>
        <translation>direzione del carico</translation>
    </message>
    <message>
        <source>the job has no motion to compare with</source>
        <translation>il lavoro non ha un movimento con cui confrontare</translation>
    </message>
    <message>
        <source>give rows such as: length x 50 49.8; slot y 5 4.8; hole 10 9.6</source>
        <translation>indica righe come: length x 50 49.8; slot y 5 4.8; hole 10 9.6</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not a size</source>
        <translation>&apos;{word}&apos; non è una misura</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not a kind of size</source>
        <translation>&apos;{word}&apos; non è un tipo di misura</translation>
    </message>
    <message>
        <source>not a kind, an axis and two sizes</source>
        <translation>non un tipo, un asse e due misure</translation>
    </message>
    <message>
        <source>{measured} is too far from {nominal}</source>
        <translation>{measured} è troppo lontano da {nominal}</translation>
    </message>
    <message>
        <source>{key} would be {value}, beyond {least} to {most}</source>
        <translation>{key} sarebbe {value}, fuori da {least} a {most}</translation>
    </message>
    <message>
        <source>check the measured sizes</source>
        <translation>controlla le misure rilevate</translation>
    </message>
    <message>
        <source>no measured sizes</source>
        <translation>nessuna misura rilevata</translation>
    </message>
    <message>
        <source>aligning</source>
        <translation>allineamento</translation>
    </message>
    <message>
        <source>path</source>
        <translation>percorso</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>velocità</translation>
    </message>
    <message>
        <source>flow</source>
        <translation>flusso</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>mancante</translation>
    </message>
    <message>
        <source>the record does not come near the planned path</source>
        <translation>la registrazione non si avvicina al percorso pianificato</translation>
    </message>
    <message>
        <source>choose the project and the cell that it was recorded with</source>
        <translation>scegli il progetto e la cella con cui è stata registrata</translation>
    </message>
    <message>
        <source>{found} joints are recorded, the cell has {wanted} axes</source>
        <translation>sono registrati {found} giunti, la cella ha {wanted} assi</translation>
    </message>
    <message>
        <source>record all axes, external ones included</source>
        <translation>registra tutti gli assi, anche quelli esterni</translation>
    </message>
    <message>
        <source>poses of the TCP do not contain the external axes</source>
        <translation>le pose del TCP non contengono gli assi esterni</translation>
    </message>
    <message>
        <source>record the joints of all axes</source>
        <translation>registra i giunti di tutti gli assi</translation>
    </message>
    <message>
        <source>the pose of the TCP is incomplete</source>
        <translation>la posa del TCP è incompleta</translation>
    </message>
    <message>
        <source>record actual_q or all of actual_TCP_pose</source>
        <translation>registra actual_q o tutto actual_TCP_pose</translation>
    </message>
    <message>
        <source>column &apos;{name}&apos; is missing</source>
        <translation>manca la colonna &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>record X, Y, Z, A, B and C, or all joints</source>
        <translation>registra X, Y, Z, A, B e C, o tutti i giunti</translation>
    </message>
    <message>
        <source>RTDE of Universal Robots</source>
        <translation>RTDE di Universal Robots</translation>
    </message>
    <message>
        <source>monitor of MELFA</source>
        <translation>monitor di MELFA</translation>
    </message>
    <message>
        <source>table of joints</source>
        <translation>tabella di giunti</translation>
    </message>
    <message>
        <source>no joints and no pose of the TCP among the columns</source>
        <translation>nessun giunto e nessuna posa del TCP tra le colonne</translation>
    </message>
    <message>
        <source>record actual_q (RTDE), X to C (MELFA) or j1_deg, j2_deg ...</source>
        <translation>registra actual_q (RTDE), da X a C (MELFA) o j1_deg, j2_deg ...</translation>
    </message>
    <message>
        <source>no column of times</source>
        <translation>nessuna colonna dei tempi</translation>
    </message>
    <message>
        <source>name it timestamp, time_s or time_ms</source>
        <translation>chiamala timestamp, time_s o time_ms</translation>
    </message>
    <message>
        <source>fewer than two samples</source>
        <translation>meno di due campioni</translation>
    </message>
    <message>
        <source>record the whole run</source>
        <translation>registra l&apos;intera esecuzione</translation>
    </message>
    <message>
        <source>no number in column &apos;{column}&apos;</source>
        <translation>nessun numero nella colonna &apos;{column}&apos;</translation>
    </message>
    <message>
        <source>{found} values in a row instead of {wanted}, as there are names</source>
        <translation>{found} valori in una riga invece di {wanted}, quanti sono i nomi</translation>
    </message>
    <message>
        <source>no rows of numbers below a row of names</source>
        <translation>nessuna riga di numeri sotto una riga di nomi</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a direction</source>
        <translation>&apos;{text}&apos; non è una direzione</translation>
    </message>
    <message>
        <source>give x,y,z, for example 1,0,0</source>
        <translation>indica x,y,z, per esempio 1,0,0</translation>
    </message>
    <message>
        <source>the job waits for another machine at marks</source>
        <translation>il lavoro attende un&apos;altra macchina ai segnali</translation>
    </message>
    <message>
        <source>resume the job from which it was made, and print its rest alone</source>
        <translation>riprendere il lavoro da cui è stato fatto, e stampare il resto da solo</translation>
    </message>
    <message>
        <source>milling passes</source>
        <translation>passate di fresatura</translation>
    </message>
    <message>
        <source>milling the block</source>
        <translation>fresatura del blocco</translation>
    </message>
    <message>
        <source>another motion than planned</source>
        <translation>un movimento diverso da quello pianificato</translation>
    </message>
    <message>
        <source>laying the part down</source>
        <translation>orientamento del pezzo nel blocco</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>negative volume</source>
        <translation>volume negativo</translation>
    </message>
    <message>
        <source>modifier volume</source>
        <translation>volume modificatore</translation>
    </message>
    <message>
        <source>support enforcer</source>
        <translation>rinforzo dei supporti</translation>
    </message>
    <message>
        <source>support blocker</source>
        <translation>blocco dei supporti</translation>
    </message>
    <message>
        <source>not used: extruder {number} of &apos;{object}&apos; ({where}): choose the tool of the part</source>
        <translation>non usato: estrusore {number} di «{object}» ({where}): scegliere l&apos;utensile del pezzo</translation>
    </message>
    <message>
        <source>not used: settings of &apos;{object}&apos; ({where}): {keys}</source>
        <translation>non usate: impostazioni di «{object}» ({where}): {keys}</translation>
    </message>
    <message>
        <source>not used: the slice stack of object &apos;{id}&apos; ({where}): its mesh is printed</source>
        <translation>non usate: le fette dell&apos;oggetto «{id}» ({where}): si stampa la sua mesh</translation>
    </message>
    <message>
        <source>cut away: {kind} &apos;{name}&apos; of &apos;{object}&apos;, its middle at {place} in the file</source>
        <translation>tagliato via: {kind} «{name}» di «{object}», con il centro in {place} nel file</translation>
    </message>
    <message>
        <source>not used: {kind} &apos;{name}&apos; of &apos;{object}&apos;, its middle at {place} in the file</source>
        <translation>non usato: {kind} «{name}» di «{object}», con il centro in {place} nel file</translation>
    </message>
    <message>
        <source>read although its namespace is &apos;{space}&apos; and not that of 3MF ({where})</source>
        <translation>letto benché il suo spazio dei nomi sia «{space}» e non quello di 3MF ({where})</translation>
    </message>
    <message>
        <source>not used: materials and colours of objects and triangles, more than one from line {line} of {where}</source>
        <translation>non usati: materiali e colori di oggetti e triangoli, più di uno dalla riga {line} di {where}</translation>
    </message>
    <message>
        <source>M200 changes the meaning of E between beads</source>
        <translation>M200 cambia il significato di E tra i cordoni</translation>
    </message>
    <message>
        <source>export the whole file with lengths of filament, or with volumes</source>
        <translation>esportare tutto il file con lunghezze di filamento, o con volumi</translation>
    </message>
    <message>
        <source>purge lines beside the part are left out: {volume:.0f} from line {line} on</source>
        <translation>linee di spurgo accanto al pezzo omesse: {volume:.0f} dalla riga {line} in poi</translation>
    </message>
    <message>
        <source>amounts are taken as volumes, as the setting use_volumetric_e of the file says</source>
        <translation>le quantità sono lette come volumi, come dice l&apos;impostazione use_volumetric_e del file</translation>
    </message>
    <message>
        <source>the negative volume &apos;{negative}&apos; cannot be cut out of &apos;{part}&apos;: their meshes are not closed or intersect themselves</source>
        <translation>il volume negativo «{negative}» non può essere tagliato da «{part}»: le loro mesh non sono chiuse o si intersecano</translation>
    </message>
    <message>
        <source>repair them in the slicer, or export the part as STL</source>
        <translation>ripararle nello slicer, o esportare il pezzo come STL</translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} elements {name}, the first in line {line} of {where}</source>
        <translation>
            <numerusform>non usato: {count} elemento {name}, nella riga {line} di {where}</numerusform>
            <numerusform>non usati: {count} elementi {name}, il primo nella riga {line} di {where}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: attribute {name} of {count} elements {element}, the first in line {line} of {where}</source>
        <translation>
            <numerusform>non usato: attributo {name} di {count} elemento {element}, nella riga {line} di {where}</numerusform>
            <numerusform>non usato: attributo {name} di {count} elementi {element}, il primo nella riga {line} di {where}</numerusform>
        </translation>
    </message>
    <message>
        <source>not used: metadata &apos;{name}&apos; ({where})</source>
        <translation>non usati: metadati «{name}» ({where})</translation>
    </message>
    <message>
        <source>not used: the division into {plates} plates ({where}): the parts of all are read</source>
        <translation>non usata: la divisione in {plates} piatti ({where}): si leggono i pezzi di tutti</translation>
    </message>
    <message>
        <source>not used: settings of plates ({where}): {keys}</source>
        <translation>non usate: impostazioni dei piatti ({where}): {keys}</translation>
    </message>
    <message>
        <source>printed like the part: a volume of the unknown kind &apos;{kind}&apos; ({where})</source>
        <translation>stampato come il pezzo: un volume del tipo sconosciuto «{kind}» ({where})</translation>
    </message>
    <message>
        <source>the slicer&apos;s settings</source>
        <translation>le impostazioni dello slicer</translation>
    </message>
    <message>
        <source>variable layer heights</source>
        <translation>altezze variabili degli strati</translation>
    </message>
    <message>
        <source>settings of ranges of height</source>
        <translation>impostazioni di intervalli di altezza</translation>
    </message>
    <message>
        <source>stops, tools and G-code at given heights</source>
        <translation>arresti, utensili e G-code a certe altezze</translation>
    </message>
    <message>
        <source>points of support</source>
        <translation>punti di supporto</translation>
    </message>
    <message>
        <source>drain holes</source>
        <translation>fori di scarico</translation>
    </message>
    <message>
        <source>ears of the brim</source>
        <translation>orecchie della tesa</translation>
    </message>
    <message>
        <source>not used: {what} (&apos;{member}&apos;)</source>
        <translation>non usato: {what} («{member}»)</translation>
    </message>
    <message>
        <source>not used: {count} further members of the package</source>
        <translation>non usati: altri {count} file del pacchetto</translation>
    </message>
    <message>
        <source>not used: &apos;{member}&apos; in the package</source>
        <translation>non usato: «{member}» nel pacchetto</translation>
    </message>
    <message>
        <source>not used, as they are damaged: kinds and settings of objects ({where}): modifiers and negative volumes may be printed as parts: {why}</source>
        <translation>non usati perché danneggiati: tipi e impostazioni degli oggetti ({where}): modificatori e volumi negativi possono essere stampati come pezzi: {why}</translation>
    </message>
    <message>
        <source>does not have three numbers</source>
        <translation>non ha tre numeri</translation>
    </message>
    <message>
        <source>refers to a missing vertex</source>
        <translation>si riferisce a un vertice mancante</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>non ha triangoli</translation>
    </message>
    <message>
        <source>is another version</source>
        <translation>è un&apos;altra versione</translation>
    </message>
    <message>
        <source>is unknown</source>
        <translation>è sconosciuto</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): overhang after cutting {left:.0f} (pieces: {pieces}) instead of {leftBefore:.0f#} (pieces: {piecesBefore}, estimated); uncut {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>il pezzo è stato girato di {angle:.0f} attorno a ({x}, {y}, {z}): sbalzo dopo i tagli {left:.0f} (parti: {pieces}) invece di {leftBefore:.0f#} (parti: {piecesBefore}, stimato); senza tagli {overhang:.0f} invece di {overhangBefore:.0f#}</translation>
    </message>
    <message numerus="yes">
        <source>{shots} shots into pockets last up to {seconds:.1f}: after {most:.0f} in a pocket the nozzle melts the layers around it</source>
        <translation>
            <numerusform>{shots} iniezione in una tasca dura fino a {seconds:.1f}: dopo {most:.0f} nella tasca l&apos;ugello fonde gli strati attorno</numerusform>
            <numerusform>{shots} iniezioni nelle tasche durano fino a {seconds:.1f}: dopo {most:.0f} in una tasca l&apos;ugello fonde gli strati attorno</numerusform>
        </translation>
    </message>
    <message>
        <source>use a process with a greater flow, or smaller pockets (`stitchDiameter`)</source>
        <translation>usa un processo con una portata maggiore, o tasche più piccole (`stitchDiameter`)</translation>
    </message>
    <message>
        <source>support in closed hollows of the part cannot be removed: {volume:.3g}</source>
        <translation>i supporti nelle cavità chiuse del pezzo non si possono togliere: {volume:.3g}</translation>
    </message>
    <message>
        <source>too many intersecting triangles to unite them ({pairs} pairs, at most {most}): shells stay as they are, overlaps count as one solid when layers are made</source>
        <translation>troppi triangoli si intersecano per unirli ({pairs} coppie, al massimo {most}): i gusci restano come sono, le sovrapposizioni contano come un solo solido quando si fanno gli strati</translation>
    </message>
    <message>
        <source>change parameters, process or cell of the plan, or leave this format out</source>
        <translation>cambia parametri, processo o cella del piano, o tralascia questo formato</translation>
    </message>
    <message>
        <source>choose another program format</source>
        <translation>scegli un altro formato di programma</translation>
    </message>
    <message>
        <source>the tool-paths are those of the file: change them where they were made</source>
        <translation>i percorsi sono quelli del file: cambiali dove sono stati fatti</translation>
    </message>
    <message>
        <source>slice the part again with supports there, or with denser infill; its tool-paths are printed as they are</source>
        <translation>affetta di nuovo il pezzo con supporti in quel punto, o con un riempimento più denso; i suoi percorsi si stampano come sono</translation>
    </message>
    <message>
        <source>check the widths and layer heights in the slicer against the bead of the process; the tool-paths are printed as they are</source>
        <translation>confronta larghezze e altezze degli strati nello slicer con il cordone del processo; i percorsi si stampano come sono</translation>
    </message>
    <message>
        <source>check the flow in the slicer, and purge or prime lines that it does not mark; the tool-paths are printed as they are</source>
        <translation>controlla la portata nello slicer, e le linee di spurgo o di innesco che non contrassegna; i percorsi si stampano come sono</translation>
    </message>
    <message>
        <source>check the slicer&apos;s flow, its filament diameter and its amounts at tool changes; the tool-paths are printed as they are</source>
        <translation>controlla la portata dello slicer, il suo diametro del filamento e le sue quantità ai cambi di utensile; i percorsi si stampano come sono</translation>
    </message>
    <message>
        <source>no {format} program: {why}</source>
        <translation>nessun programma {format}: {why}</translation>
    </message>
    <message>
        <source>the {format} program lays beads by position, without the force of process {process}</source>
        <translation>il programma {format} posa i cordoni per posizione, senza la forza del processo {process}</translation>
    </message>
    <message>
        <source>to press with the force, use {formats}, or add the statements to the process (beadWords)</source>
        <translation>per premere con la forza, usa {formats}, o aggiungi le istruzioni al processo (beadWords)</translation>
    </message>
    <message numerus="yes">
        <source>not used: {command} in {count} lines, the first is line {line}</source>
        <translation>
            <numerusform>non usato: {command} in {count} riga, la riga {line}</numerusform>
            <numerusform>non usato: {command} in {count} righe, la prima è la riga {line}</numerusform>
        </translation>
    </message>
    <message>
        <source>{cell}: best of the planned rows (row {row})</source>
        <translation>{cell}: la migliore delle righe pianificate (riga {row})</translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} statements &apos;{word}&apos;, the first in line {line}</source>
        <translation>
            <numerusform>non usata: {count} istruzione «{word}», nella riga {line}</numerusform>
            <numerusform>non usate: {count} istruzioni «{word}», la prima nella riga {line}</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not followed by a joint motion: it changes the speed of a later travel</source>
        <translation>dopo &apos;{word}&apos; non segue un moto dei giunti: cambia la velocità di uno spostamento successivo</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is out already</source>
        <translation>la lama del nastro è già fuori</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is not out</source>
        <translation>la lama del nastro non è fuori</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is out for {time:.2f}: it needs {least:.1f} to {most:.1f}</source>
        <translation>la lama del nastro resta fuori per {time:.2f}: servono da {least:.1f} a {most:.1f}</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is not drawn back</source>
        <translation>la lama del nastro non viene ritirata</translation>
    </message>
    <message>
        <source>outside the function of a part: &apos;{code}&apos;</source>
        <translation>fuori dalla funzione di una parte: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>the cutter&apos;s output needs S255 or S0</source>
        <translation>l&apos;uscita della lama vuole S255 o S0</translation>
    </message>
    <message>
        <source>the cutter&apos;s output runs ahead of the motions: M400 is missing before it</source>
        <translation>l&apos;uscita della lama precede i moti: prima manca M400</translation>
    </message>
    <message>
        <source>the first module declares &apos;{procedure}&apos;, too</source>
        <translation>anche il primo modulo dichiara &apos;{procedure}&apos;</translation>
    </message>
    <message>
        <source>frame {id} follows frame {before}: frames are missing or in another order</source>
        <translation>il pacchetto {id} segue il pacchetto {before}: mancano pacchetti o sono in un altro ordine</translation>
    </message>
    <message>
        <source>the velocity at this point leads off the path</source>
        <translation>la velocità in questo punto porta fuori dal percorso</translation>
    </message>
    <message>
        <source>the motors&apos; power for the first motion</source>
        <translation>la potenza dei motori per il primo moto</translation>
    </message>
    <message>
        <source>full</source>
        <translation>piena</translation>
    </message>
    <message>
        <source>low</source>
        <translation>ridotta</translation>
    </message>
    <message>
        <source>no place differs from the plan by more than the tolerances</source>
        <translation>nessun punto differisce dal piano oltre le tolleranze</translation>
    </message>
    <message numerus="yes">
        <source>{count} places are beyond the tolerances</source>
        <translation>
            <numerusform>{count} punto è oltre le tolleranze</numerusform>
            <numerusform>{count} punti sono oltre le tolleranze</numerusform>
        </translation>
    </message>
    <message>
        <source>only {recorded:.1f} of {planned:.1f} of beads are recorded</source>
        <translation>sono registrati solo {recorded:.1f} di {planned:.1f} di cordoni</translation>
    </message>
    <message>
        <source>this is no record of this job: {recorded:.1f} of {planned:.1f} of beads agree</source>
        <translation>questa non è una registrazione di questo lavoro: corrispondono {recorded:.1f} di {planned:.1f} di cordoni</translation>
    </message>
    <message>
        <source>Plan: {finding}.</source>
        <translation>Piano: {finding}.</translation>
    </message>
    <message numerus="yes">
        <source>Plan: {count} more blocking findings.</source>
        <translation>
            <numerusform>Piano: un&apos;altra segnalazione bloccante.</numerusform>
            <numerusform>Piano: altre {count} segnalazioni bloccanti.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not approved: the plan has blocking findings.</source>
        <translation>Non approvato: il piano ha segnalazioni bloccanti.</translation>
    </message>
    <message>
        <source>exists, perhaps with measured frames and obstacles</source>
        <translation>esiste già, forse con riferimenti misurati e ostacoli</translation>
    </message>
    <message>
        <source>give another name, --id, or replace it: --replace</source>
        <translation>dai un altro nome, --id, oppure sostituiscilo: --replace</translation>
    </message>
    <message>
        <source>a share that is not positive</source>
        <translation>una quota non positiva</translation>
    </message>
    <message>
        <source>amounts are taken as volumes, as UltiGCode states them</source>
        <translation>le quantità sono lette come volumi, come le indica UltiGCode</translation>
    </message>
    <message>
        <source>give S in percent</source>
        <translation>indicare S in percento</translation>
    </message>
    <message>
        <source>two commands in one line: &apos;{code}&apos; and &apos;{next}&apos;</source>
        <translation>due comandi in una riga: &apos;{code}&apos; e &apos;{next}&apos;</translation>
    </message>
    <message>
        <source>write each command in a line of its own</source>
        <translation>scrivere ogni comando in una riga propria</translation>
    </message>
    <message>
        <source>a second object of the id &apos;{id}&apos;</source>
        <translation>un secondo oggetto con l&apos;id &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>cells of {pitch} are too fine for a block of {along} by {across}</source>
        <translation>celle di {pitch} sono troppo fini per un blocco di {along} per {across}</translation>
    </message>
    <message>
        <source>give --pitch of {least} or more</source>
        <translation>indicare --pitch di {least} o più</translation>
    </message>
    <message>
        <source>must be within a kilometre</source>
        <translation>deve essere entro un chilometro</translation>
    </message>
    <message>
        <source>not used: {bytes} bytes behind the {facets} facets that the header states</source>
        <translation>non usati: {bytes} byte dopo le {facets} facce che l&apos;intestazione indica</translation>
    </message>
    <message>
        <source>under G93 a way from an unknown place has no speed</source>
        <translation>con G93 un tragitto da un punto sconosciuto non ha velocità</translation>
    </message>
    <message>
        <source>the table turns while the nozzle goes to its start</source>
        <translation>la tavola gira mentre l&apos;ugello va al suo punto di partenza</translation>
    </message>
    <message>
        <source>the nozzle is not above its start: its way has no speed</source>
        <translation>l&apos;ugello non è sopra il suo punto di partenza: il tragitto non ha velocità</translation>
    </message>
    <message>
        <source>the nozzle&apos;s height beside the print</source>
        <translation>l&apos;altezza dell&apos;ugello fuori dalla stampa</translation>
    </message>
    <message>
        <source>at least {height:.1f}</source>
        <translation>almeno {height:.1f}</translation>
    </message>
    <message>
        <source>the heat of {tool}</source>
        <translation>il riscaldamento di {tool}</translation>
    </message>
    <message>
        <source>the payload</source>
        <translation>il carico utile</translation>
    </message>
    <message>
        <source>the payload is not set</source>
        <translation>il carico utile non è impostato</translation>
    </message>
    <message>
        <source>the payload&apos;s centre, mm</source>
        <translation>il baricentro del carico utile, mm</translation>
    </message>
    <message>
        <source>a payload&apos;s centre is no sensible place</source>
        <translation>il baricentro del carico utile non è un punto plausibile</translation>
    </message>
    <message>
        <source>this text does not go to the extruder as those before it</source>
        <translation>questo testo non va all&apos;estrusore come quelli prima</translation>
    </message>
    <message>
        <source>the head is {tip:.3g} wide at its tip and {end:.3g} at its other end: its nozzle seems to point away from the part</source>
        <translation>la testa è larga {tip:.3g} alla punta e {end:.3g} all&apos;altra estremità: il suo ugello sembra puntare lontano dal pezzo</translation>
    </message>
    <message>
        <source>turn the head of process {process} over</source>
        <translation>capovolgi la testa del processo {process}</translation>
    </message>
    <message>
        <source>the plates of machine {one} ({cell}) and machine {two} ({other}) overlap by {depth:.1f} ({area:.0f})</source>
        <translation>i piani della macchina {one} ({cell}) e della macchina {two} ({other}) si sovrappongono di {depth:.1f} ({area:.0f})</translation>
    </message>
    <message>
        <source>{volume:.1f} extruded at rest are left out, from line {line} on</source>
        <translation>{volume:.1f} estrusi da fermo sono omessi, dalla riga {line} in poi</translation>
    </message>
    <message>
        <source>{volume:.0f} extruded by the printer&apos;s own code are left out, from line {line} on</source>
        <translation>{volume:.0f} estrusi dal codice proprio della stampante sono omessi, dalla riga {line} in poi</translation>
    </message>
    <message>
        <source>the file states the filament diameter &apos;{text}&apos;: {diameter} assumed for values that cannot be used; for another one set `pathsFlow`</source>
        <translation>il file indica il diametro del filamento «{text}»: {diameter} assunto per i valori inutilizzabili; per un altro impostare `pathsFlow`</translation>
    </message>
    <message>
        <source>the program ends here, beads that follow in line {line} would not be printed</source>
        <translation>il programma finisce qui, i cordoni che seguono nella riga {line} non sarebbero stampati</translation>
    </message>
    <message>
        <source>remove the end (M2, M30, M112), or everything that follows it</source>
        <translation>rimuovere la fine (M2, M30, M112), o tutto ciò che la segue</translation>
    </message>
    <message numerus="yes">
        <source>{count} settings have no effect on the tool-paths of a file: {keys}</source>
        <translation>
            <numerusform>{count} impostazione non ha effetto sui percorsi di un file: {keys}</numerusform>
            <numerusform>{count} impostazioni non hanno effetto sui percorsi di un file: {keys}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the job has {count} tools: its first tool prints the file&apos;s beads of {tools}</source>
        <translation>
            <numerusform>il lavoro ha {count} utensile: il primo stampa i cordoni del file di {tools}</numerusform>
            <numerusform>il lavoro ha {count} utensili: il primo stampa i cordoni del file di {tools}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} entries of the element &apos;{name}&apos;</source>
        <translation>
            <numerusform>non usato: {count} elemento «{name}»</numerusform>
            <numerusform>non usati: {count} elementi «{name}»</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>divided into triangles: {count} facets of more than three vertices, the first in line {line}</source>
        <translation>
            <numerusform>divisa in triangoli: {count} faccetta con più di tre vertici, nella riga {line}</numerusform>
            <numerusform>divise in triangoli: {count} faccette con più di tre vertici, la prima nella riga {line}</numerusform>
        </translation>
    </message>
    <message>
        <source>two joints are named &apos;{joint}&apos;</source>
        <translation>due giunti hanno il nome «{joint}»</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos;: the limits of its safety controller leave no room</source>
        <translation>giunto «{joint}»: i limiti del suo controllore di sicurezza non lasciano spazio</translation>
    </message>
    <message>
        <source>the time runs backwards, from {before:.3f} to {after:.3f} after the first row</source>
        <translation>il tempo va all&apos;indietro, da {before:.3f} a {after:.3f} dopo la prima riga</translation>
    </message>
    <message>
        <source>record one run in one file</source>
        <translation>registrare una sola esecuzione per file</translation>
    </message>
    <message>
        <source>not used: the material or colour of objects and triangles, from line {line} of {where}</source>
        <translation>non usato: il materiale o il colore di oggetti e triangoli, dalla riga {line} di {where}</translation>
    </message>
    <message>
        <source>not used: the recommended extension &apos;{name}&apos; ({where})</source>
        <translation>non usata: l&apos;estensione consigliata «{name}» ({where})</translation>
    </message>
    <message>
        <source>not used: the unit {unit} of {where}: its lengths are taken in {main}, the unit of the main model</source>
        <translation>non usata: l&apos;unità {unit} di {where}: le sue lunghezze sono prese in {main}, l&apos;unità del modello principale</translation>
    </message>
    <message>
        <source>not used: the layer &apos;{path}&apos;, which is not in the list of layers</source>
        <translation>non usato: lo strato «{path}», che non è nell&apos;elenco degli strati</translation>
    </message>
    <message>
        <source>the name of the folder is empty</source>
        <translation>il nome della cartella è vuoto</translation>
    </message>
    <message>
        <source>name a folder for the results</source>
        <translation>indicare una cartella per i risultati</translation>
    </message>
    <message>
        <source>beads of {least} to {most} do not fit a nozzle of {nozzle}</source>
        <translation>cordoni da {least} a {most} non sono adatti a un ugello di {nozzle}</translation>
    </message>
    <message>
        <source>check nozzleDiameterMm and beadWidthMm</source>
        <translation>controllare nozzleDiameterMm e beadWidthMm</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is no pair x,radius</source>
        <translation>«{text}» non è una coppia x,raggio</translation>
    </message>
    <message>
        <source>contains no points</source>
        <translation>non contiene punti</translation>
    </message>
    <message>
        <source>give numbers in mm, separated by commas: x,y,z</source>
        <translation>indicare numeri in mm, separati da virgole: x,y,z</translation>
    </message>
    <message>
        <source>is no result of this kind of job, and would be replaced</source>
        <translation>non è un risultato di questo tipo di lavoro, e sarebbe sostituito</translation>
    </message>
    <message>
        <source>choose another folder, or give --replace</source>
        <translation>scegliere un&apos;altra cartella, o indicare --replace</translation>
    </message>
    <message>
        <source>give it for the job: --set {key}=...</source>
        <translation>impostalo per il lavoro: --set {key}=...</translation>
    </message>
    <message>
        <source>one mesh</source>
        <translation>una mesh</translation>
    </message>
    <message>
        <source>one mesh; read by a program of its own</source>
        <translation>una mesh; letta da un programma a parte</translation>
    </message>
    <message>
        <source>several parts, or tool-paths (build files)</source>
        <translation>più pezzi, o percorsi utensile (file di costruzione)</translation>
    </message>
    <message>
        <source>solid cells, drawn as text</source>
        <translation>celle piene, disegnate come testo</translation>
    </message>
    <message>
        <source>tool-paths of a slicer</source>
        <translation>percorsi di uno slicer</translation>
    </message>
    <message>
        <source>{key} is a setting of the job, not of a part</source>
        <translation>{key} è un&apos;impostazione del lavoro, non di un pezzo</translation>
    </message>
    <message>
        <source>use one of these formats: {formats}</source>
        <translation>usa uno di questi formati: {formats}</translation>
    </message>
    <message>
        <source>the project of a station of several machines, not a part</source>
        <translation>il progetto di una stazione di più macchine, non un pezzo</translation>
    </message>
    <message>
        <source>give it to &apos;together&apos;, &apos;verify&apos; or &apos;resume&apos;; a part is a file of its own</source>
        <translation>passalo a &apos;together&apos;, &apos;verify&apos; o &apos;resume&apos;; un pezzo è un file a sé</translation>
    </message>
    <message>
        <source>a project, not a part</source>
        <translation>un progetto, non un pezzo</translation>
    </message>
    <message>
        <source>give it to &apos;resume&apos;, &apos;verify&apos; or &apos;together&apos;; a part is a file of its own</source>
        <translation>passalo a &apos;resume&apos;, &apos;verify&apos; o &apos;together&apos;; un pezzo è un file a sé</translation>
    </message>
    <message>
        <source>not the file of a part</source>
        <translation>non è il file di un pezzo</translation>
    </message>
    <message>
        <source>the file ends within line {line}, without a line end: it may be cut there, and the part unfinished; export it again</source>
        <translation>il file finisce dentro la riga {line}, senza fine riga: potrebbe essere troncato lì e il pezzo incompleto; esportalo di nuovo</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is more than a kilometre away</source>
        <translation>&apos;{text}&apos; è a più di un chilometro</translation>
    </message>
    <message>
        <source>give places in mm</source>
        <translation>indica le posizioni in mm</translation>
    </message>
    <message>
        <source>there is no curve for tapes</source>
        <translation>non ci sono curve per i nastri</translation>
    </message>
    <message>
        <source>this text goes nowhere: the connection &apos;{name}&apos; is not open</source>
        <translation>questo testo non va da nessuna parte: la connessione &apos;{name}&apos; non è aperta</translation>
    </message>
    <message>
        <source>a connection needs an address and a port</source>
        <translation>una connessione richiede un indirizzo e una porta</translation>
    </message>
    <message>
        <source>this file moves the arm before it states the payload</source>
        <translation>questo file muove il braccio prima di dichiarare il carico utile</translation>
    </message>
    <message>
        <source>this file sets the flow before it states the range of the output</source>
        <translation>questo file imposta il flusso prima di dichiarare il campo dell&apos;uscita</translation>
    </message>
    <message>
        <source>G28 with a number goes to a place first: give letters alone, or none</source>
        <translation>G28 con un numero va prima in un punto: dare solo le lettere, o niente</translation>
    </message>
    <message>
        <source>G94 is missing before this motion: after a run that was stopped its F would be read as a time</source>
        <translation>G94 manca prima di questo movimento: dopo un&apos;esecuzione interrotta la sua F sarebbe letta come tempo</translation>
    </message>
    <message>
        <source>change the places of the machines in their table</source>
        <translation>cambiare le posizioni delle macchine nella loro tabella</translation>
    </message>
    <message>
        <source>every two machines can work together, but no order of work was found for all</source>
        <translation>due macchine qualsiasi possono lavorare insieme, ma non è stato trovato un ordine di lavoro per tutte</translation>
    </message>
    <message>
        <source>give a bead or a line for each machine, in their order</source>
        <translation>dare un cordone o una riga per ogni macchina, nel loro ordine</translation>
    </message>
    <message>
        <source>give it to &apos;together&apos;, or the job.voluta of one machine here</source>
        <translation>darlo a &apos;together&apos;, oppure dare qui il job.voluta di una macchina</translation>
    </message>
    <message>
        <source>increase the minimum distance of moving arms, or place the machines further apart</source>
        <translation>aumentare la distanza minima dei bracci in movimento, o allontanare le macchine</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>è una cartella</translation>
    </message>
    <message>
        <source>no order of work keeps the machines apart: {first} of machine {one} and {second} of machine {two} hinder each other</source>
        <translation>nessun ordine di lavoro tiene separate le macchine: {first} della macchina {one} e {second} della macchina {two} si ostacolano</translation>
    </message>
    <message>
        <source>no program of it passed that states the arm</source>
        <translation>nessun suo programma che indichi il braccio è stato approvato</translation>
    </message>
    <message>
        <source>not the project of a station</source>
        <translation>non è il progetto di una stazione</translation>
    </message>
    <message>
        <source>place the machines further apart if they stand at two plates</source>
        <translation>allontanare le macchine se lavorano su due piani diversi</translation>
    </message>
    <message>
        <source>place the machines further apart, or the parts further from the border</source>
        <translation>allontanare le macchine, o le parti dal confine</translation>
    </message>
    <message>
        <source>place the machines further apart, the parts further from the border, or the arms at rest further from it</source>
        <translation>allontanare le macchine, le parti dal confine o i bracci a riposo dal confine</translation>
    </message>
    <message>
        <source>see the report of that machine</source>
        <translation>vedere il rapporto di quella macchina</translation>
    </message>
    <message>
        <source>the file of the station is truncated</source>
        <translation>il file della stazione è troncato</translation>
    </message>
    <message>
        <source>the folder holds no program of the station</source>
        <translation>la cartella non contiene programmi della stazione</translation>
    </message>
    <message>
        <source>the header of the station&apos;s file is damaged</source>
        <translation>l&apos;intestazione del file della stazione è danneggiata</translation>
    </message>
    <message>
        <source>the part of machine {one} or {two} is inside the part, the plate or an obstacle of the other</source>
        <translation>la parte della macchina {one} o {two} è dentro la parte, il piano o un ostacolo dell&apos;altra</translation>
    </message>
    <message>
        <source>the place of a machine is damaged</source>
        <translation>la posizione di una macchina è danneggiata</translation>
    </message>
    <message>
        <source>the program is refused</source>
        <translation>il programma è respinto</translation>
    </message>
    <message>
        <source>the project is not of machines that work together</source>
        <translation>il progetto non è di macchine che lavorano insieme</translation>
    </message>
    <message>
        <source>the project of a station of several machines, not of one job</source>
        <translation>il progetto di una stazione di più macchine, non di un solo lavoro</translation>
    </message>
    <message>
        <source>the rules of the station are damaged</source>
        <translation>le regole della stazione sono danneggiate</translation>
    </message>
    <message>
        <source>the station has no machines</source>
        <translation>la stazione non ha macchine</translation>
    </message>
    <message>
        <source>write the programs of all machines again</source>
        <translation>scrivere di nuovo i programmi di tutte le macchine</translation>
    </message>
    <message>
        <source>{body} of machine {one} meets {obstacle} of machine {two} ({layer})</source>
        <translation>{body} della macchina {one} urta {obstacle} della macchina {two} ({layer})</translation>
    </message>
    <message>
        <source>{body} of machine {one} meets {obstacle} of machine {two} after {time}; collisions of the machines: {collisions}</source>
        <translation>{body} della macchina {one} urta {obstacle} della macchina {two} dopo {time}; collisioni delle macchine: {collisions}</translation>
    </message>
    <message>
        <source>{places} places for {machines} machines</source>
        <translation>{places} posizioni per {machines} macchine</translation>
    </message>
    <message>
        <source>bead {bead} is printed: this rest begins with bead {first}</source>
        <translation>il cordone {bead} è già stampato: questo resto comincia con il cordone {first}</translation>
    </message>
    <message>
        <source>beads have the numbers of the whole print</source>
        <translation>i cordoni hanno i numeri della stampa intera</translation>
    </message>
    <message>
        <source>the place of a machine</source>
        <translation>la posizione di una macchina</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Accetta</translation>
    </message>
    <message>
        <source>How far the printed part may differ from the requested one before the plan is marked. Never changes what is safe to run.</source>
        <translation>Quanto il pezzo stampato può differire da quello richiesto prima che il piano sia segnalato. Non cambia mai ciò che è sicuro eseguire.</translation>
    </message>
    <message>
        <source>In this job; the verification report lists it</source>
        <translation>In questo lavoro; il rapporto di verifica lo elenca</translation>
    </message>
    <message numerus="yes">
        <source>Nothing that was checked endangers robot or cell: {checks} checks of the part are beyond their limits.</source>
        <translation>
            <numerusform>Nulla di ciò che è stato verificato mette in pericolo robot o cella: {checks} verifica del pezzo supera il suo limite.</numerusform>
            <numerusform>Nulla di ciò che è stato verificato mette in pericolo robot o cella: {checks} verifiche del pezzo superano i loro limiti.</numerusform>
        </translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualità</translation>
    </message>
    <message>
        <source>Safe to run, but it does not print the part as asked.</source>
        <translation>Sicuro da eseguire, ma non stampa il pezzo come richiesto.</translation>
    </message>
    <message>
        <source>accepted differences</source>
        <translation>differenze accettate</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>bozza</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>massa</translation>
    </message>
    <message>
        <source>overfill</source>
        <translation>eccesso</translation>
    </message>
    <message>
        <source>quality</source>
        <translation>qualità</translation>
    </message>
    <message>
        <source>strict</source>
        <translation>rigorosa</translation>
    </message>
    <message>
        <source>uncovered</source>
        <translation>non coperto</translation>
    </message>
    <message>
        <source>unsupported</source>
        <translation>non sostenuto</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>normale</translation>
    </message>
    <message>
        <source>{length:.1f} of bead ({share:.2f}) is unsupported</source>
        <translation>{length:.1f} di cordone ({share:.2f}) non è sostenuto</translation>
    </message>
    <message>
        <source>{quality}; accepted: {shares}</source>
        <translation>{quality}; accettato: {shares}</translation>
    </message>
    <message>
        <source>How a part whose surface has wide openings or no thickness is handled: close openings that are flat or small and refuse others, refuse it, close the openings with patches, thicken the surface to a wall two beads wide, or print it as one wall, one bead wide.</source>
        <translation>Come trattare un pezzo la cui superficie ha ampie aperture o nessuno spessore: chiudere le aperture piane o piccole e rifiutare le altre, rifiutarlo, chiudere le aperture con toppe, ispessire la superficie a una parete larga due cordoni, o stamparla come una sola parete larga un cordone.</translation>
    </message>
    <message>
        <source>Shares that are accepted in this job beyond the quality&apos;s limits: uncovered, unsupported, overfill, mass and thin, such as uncovered=0.05, mass=0.04. Verification reports list them.</source>
        <translation>Quote accettate in questo lavoro oltre i limiti della qualità: uncovered, unsupported, overfill, mass e thin, per esempio uncovered=0.05, mass=0.04. I rapporti di verifica le elencano.</translation>
    </message>
    <message>
        <source>The spiral follows the largest contour of each layer; holes and other contours are left out.</source>
        <translation>La spirale segue il contorno più grande di ogni strato; fori e altri contorni sono tralasciati.</translation>
    </message>
    <message>
        <source>Thin: {share:.1f} of the part is narrower than the narrowest bead and stays open; at most {limit:.4g} allowed.</source>
        <translation>Sottile: {share:.1f} del pezzo è più stretto del cordone più stretto e resta aperto; ammesso al massimo {limit:.4g}.</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatico</translation>
    </message>
    <message>
        <source>check these places in the view; move the part on the plate if they matter</source>
        <translation>controlla questi punti nella vista; sposta il pezzo sul piatto se contano</translation>
    </message>
    <message>
        <source>choose a process with narrower beads, or slice the part again with wider ones</source>
        <translation>scegli un processo con cordoni più stretti, o affetta di nuovo il pezzo con cordoni più larghi</translation>
    </message>
    <message>
        <source>choose the process that the file was sliced for; the tool-paths are printed as they are</source>
        <translation>scegli il processo per cui il file è stato affettato; i percorsi utensile si stampano così come sono</translation>
    </message>
    <message>
        <source>export the file again in millimetres, at the size to be printed</source>
        <translation>esporta di nuovo il file in millimetri, nella dimensione da stampare</translation>
    </message>
    <message>
        <source>in line {line} first</source>
        <translation>per la prima volta alla riga {line}</translation>
    </message>
    <message>
        <source>in no single line</source>
        <translation>in nessuna riga in particolare</translation>
    </message>
    <message>
        <source>look at that line: export the file again without it, with straight lines or arcs (G1, G2, G3)</source>
        <translation>guarda quella riga: esporta di nuovo il file senza di essa, con linee rette o archi (G1, G2, G3)</translation>
    </message>
    <message>
        <source>move the part on the plate, or slice it again for a lower speed there</source>
        <translation>sposta il pezzo sul piatto, o affettalo di nuovo con una velocità minore in quel punto</translation>
    </message>
    <message>
        <source>move the part on the plate, or use another cell; its tool-paths are printed as they are</source>
        <translation>sposta il pezzo sul piatto, o usa un&apos;altra cella; i suoi percorsi utensile si stampano così come sono</translation>
    </message>
    <message>
        <source>move the part on the plate, use a slimmer print head, or allow less clearance</source>
        <translation>sposta il pezzo sul piatto, usa una testa di stampa più snella, o ammetti una distanza minore</translation>
    </message>
    <message>
        <source>outer contour alone</source>
        <translation>solo il contorno esterno</translation>
    </message>
    <message>
        <source>plan again with more clearance, or move the part on the plate</source>
        <translation>pianifica di nuovo con più distanza, o sposta il pezzo sul piatto</translation>
    </message>
    <message>
        <source>see its report</source>
        <translation>vedi il suo rapporto</translation>
    </message>
    <message>
        <source>see the remedies in the job of that machine</source>
        <translation>vedi i rimedi nel lavoro di quella macchina</translation>
    </message>
    <message>
        <source>the file extrudes {stated:.0f} by its E words, its beads and what is left out have {read:.0f}; they part {line}</source>
        <translation>il file estrude {stated:.0f} secondo le sue parole E, i suoi cordoni e ciò che è tralasciato ne hanno {read:.0f}; divergono {line}</translation>
    </message>
    <message>
        <source>the file extrudes {stated:.0f} by its E words, the tool-paths taken from it have {read:.0f}; they part {line}</source>
        <translation>il file estrude {stated:.0f} secondo le sue parole E, i percorsi utensile presi da esso ne hanno {read:.0f}; divergono {line}</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>sottile</translation>
    </message>
    <message>
        <source>use a cell whose arm can tilt the nozzle, or print the paths on the plate</source>
        <translation>usa una cella il cui braccio può inclinare l&apos;ugello, o stampa i percorsi sul piatto</translation>
    </message>
    <message>
        <source>use a cell with a larger plate, or slice the part again at a smaller size</source>
        <translation>usa una cella con un piatto più grande, o affetta di nuovo il pezzo in dimensione minore</translation>
    </message>
    <message numerus="yes">
        <source>{share:.2f} of the part ({volume:.3g}) is narrower than the narrowest bead ({bead:.3g}) and stays open, at {places} places, mostly around this point</source>
        <translation>
            <numerusform>{share:.2f} del pezzo ({volume:.3g}) è più stretto del cordone più stretto ({bead:.3g}) e resta aperto, in {places} punto, qui</numerusform>
            <numerusform>{share:.2f} del pezzo ({volume:.3g}) è più stretto del cordone più stretto ({bead:.3g}) e resta aperto, in {places} punti, soprattutto attorno a questo</numerusform>
        </translation>
    </message>
    <message>
        <source>choose another pattern or another share, or a quality that accepts longer bridges</source>
        <translation>scegli un altro motivo o un&apos;altra quota, o una qualità che ammette ponti più lunghi</translation>
    </message>
    <message>
        <source>its lines branch below skins that would sag between them</source>
        <translation>le sue linee si ramificano sotto le pelli, che altrimenti cederebbero fra di esse</translation>
    </message>
    <message>
        <source>sparse infill fills {found:.0f} of the interior instead of {asked:.0f}: {reason}</source>
        <translation>il riempimento rado occupa {found:.0f} dell&apos;interno invece di {asked:.0f}: {reason}</translation>
    </message>
    <message>
        <source>the interior is too small for its lines, or they cannot lie any closer</source>
        <translation>l&apos;interno è troppo piccolo per le sue linee, oppure esse non possono stare più vicine</translation>
    </message>
    <message>
        <source>Bead width, length that it bridges with a sag of up to 0.2 mm; and so on, in mm. Quality usual and draft accept it. Those of the program&apos;s materials are estimates: replace them by those of a test print.</source>
        <translation>Larghezza del cordone, lunghezza su cui fa ponte cedendo al massimo di 0,2 mm; e così via, in mm. Le qualità usual e draft la accettano. Quelle dei materiali del programma sono stime: sostituiscile con quelle di una stampa di prova.</translation>
    </message>
    <message>
        <source>Maximum distance between waypoints along a tool-path; plain G-code has fewer where beads are straight.</source>
        <translation>Distanza massima tra i punti di un percorso utensile; il G-code semplice ne ha meno dove i cordoni sono dritti.</translation>
    </message>
    <message>
        <source>Share of the speed of a wall that overhangs the layer below by that share of its width.</source>
        <translation>Quota della velocità di una parete che sporge dallo strato sottostante di quella parte della sua larghezza.</translation>
    </message>
    <message>
        <source>add supports (`supports=auto`), turn the part, or use planar or curved mode</source>
        <translation>aggiungi supporti (`supports=auto`), ruota il pezzo, o usa pezzi piani o strati curvi</translation>
    </message>
    <message>
        <source>bridges with a little sag</source>
        <translation>ponti con un piccolo cedimento</translation>
    </message>
    <message>
        <source>choose a plate with a size, or type the number of copies</source>
        <translation>scegli un piatto con una dimensione, o scrivi il numero di copie</translation>
    </message>
    <message>
        <source>is above 1000 mm: check the unit</source>
        <translation>supera 1000 mm: controlla l&apos;unità</translation>
    </message>
    <message>
        <source>is more than with less overhang</source>
        <translation>è più che con meno sbalzo</translation>
    </message>
    <message>
        <source>is not wider than the bead before it</source>
        <translation>non è più largo del cordone che precede</translation>
    </message>
    <message>
        <source>must be a pair of bead width and length</source>
        <translation>deve essere una coppia di larghezza del cordone e lunghezza</translation>
    </message>
    <message>
        <source>must have four shares, for 25, 50, 75 and 100 % of the width</source>
        <translation>deve avere quattro quote, per il 25, 50, 75 e 100 % della larghezza</translation>
    </message>
    <message>
        <source>speed of walls, 100 % overhang</source>
        <translation>velocità delle pareti, sbalzo 100 %</translation>
    </message>
    <message>
        <source>speed of walls, 25 % overhang</source>
        <translation>velocità delle pareti, sbalzo 25 %</translation>
    </message>
    <message>
        <source>speed of walls, 50 % overhang</source>
        <translation>velocità delle pareti, sbalzo 50 %</translation>
    </message>
    <message>
        <source>speed of walls, 75 % overhang</source>
        <translation>velocità delle pareti, sbalzo 75 %</translation>
    </message>
    <message>
        <source>the plate is made as large as the parts need</source>
        <translation>il piatto è fatto grande quanto serve ai pezzi</translation>
    </message>
    <message>
        <source>write the program again, or use smaller cells for the part&apos;s map</source>
        <translation>scrivi di nuovo il programma, o usa celle più piccole per la mappa del pezzo</translation>
    </message>
    <message>
        <source>allow larger facets, or export less detail</source>
        <translation>consenti facce più grandi, o esporta meno dettagli</translation>
    </message>
    <message>
        <source>cannot be read: voluta-cad-reader is missing beside this program</source>
        <translation>non può essere letto: voluta-cad-reader manca accanto a questo programma</translation>
    </message>
    <message>
        <source>copy or export it again</source>
        <translation>copialo o esportalo di nuovo</translation>
    </message>
    <message>
        <source>export the solid from the CAD program</source>
        <translation>esporta il solido dal programma CAD</translation>
    </message>
    <message>
        <source>give it the ending .stl</source>
        <translation>dagli l&apos;estensione .stl</translation>
    </message>
    <message>
        <source>has no solid and no surface</source>
        <translation>non ha né solidi né superfici</translation>
    </message>
    <message>
        <source>has only curves, no solid and no surface</source>
        <translation>ha solo curve, né solidi né superfici</translation>
    </message>
    <message>
        <source>is an STL, not a STEP or IGES file</source>
        <translation>è un STL, non un file STEP o IGES</translation>
    </message>
    <message>
        <source>is cut short: {lacking}</source>
        <translation>è troncato: {lacking}</translation>
    </message>
    <message>
        <source>is damaged: Open CASCADE cannot read it</source>
        <translation>è danneggiato: Open CASCADE non può leggerlo</translation>
    </message>
    <message>
        <source>needs more than 4 GB of memory to read</source>
        <translation>richiede più di 4 GB di memoria per la lettura</translation>
    </message>
    <message>
        <source>not a STEP or IGES file</source>
        <translation>non è un file STEP o IGES</translation>
    </message>
    <message numerus="yes">
        <source>omitted: {n} curves</source>
        <translation>
            <numerusform>tralasciata: una curva</numerusform>
            <numerusform>tralasciate: {n} curve</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>omitted: {n} surfaces without facets</source>
        <translation>
            <numerusform>tralasciata: una superficie senza facce</numerusform>
            <numerusform>tralasciate: {n} superfici senza facce</numerusform>
        </translation>
    </message>
    <message>
        <source>one or several solids; read by a program of its own</source>
        <translation>uno o più solidi; letti da un programma a parte</translation>
    </message>
    <message>
        <source>open the hollow or turn the part; without supports (`supports=none`, `rimSupports=none`) the hollow&apos;s roof is unsupported</source>
        <translation>apri la cavità o ruota il pezzo; senza supporti (`supports=none`, `rimSupports=none`) il tetto della cavità non è sostenuto</translation>
    </message>
    <message>
        <source>surfaces are read as facets, at most {chord:.3g} off</source>
        <translation>le superfici sono lette come facce, con uno scarto di al massimo {chord:.3g}</translation>
    </message>
    <message>
        <source>takes longer than {time:.0f} to read</source>
        <translation>richiede più di {time:.0f} per la lettura</translation>
    </message>
    <message>
        <source>the end of a STEP file is missing</source>
        <translation>manca la fine di un file STEP</translation>
    </message>
    <message>
        <source>the last line of an IGES file is missing, or names other numbers of lines</source>
        <translation>l&apos;ultima riga di un file IGES manca, o indica altri numeri di righe</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; cannot be a preset&apos;s id</source>
        <translation>&apos;{id}&apos; non può essere l&apos;id di un preset</translation>
    </message>
    <message>
        <source>&apos;{key}&apos; is not a setting of presets</source>
        <translation>&apos;{key}&apos; non è un&apos;impostazione dei preset</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a list of layers</source>
        <translation>&apos;{text}&apos; non è un elenco di strati</translation>
    </message>
    <message>
        <source>Fill of what is meant to be solid: mean along the view, for beads with round edges</source>
        <translation>Riempimento di ciò che deve essere pieno: media lungo la vista, per cordoni con bordi tondi</translation>
    </message>
    <message>
        <source>Overhang
mm²</source>
        <translation>Sbalzo
mm²</translation>
    </message>
    <message>
        <source>Unprinted
voxels</source>
        <translation>Voxel
non stampati</translation>
    </message>
    <message>
        <source>a film of {length} cannot be made</source>
        <translation>non si può fare un filmato di {length}</translation>
    </message>
    <message>
        <source>a preset &apos;{id}&apos; comes with the program</source>
        <translation>un preset &apos;{id}&apos; è fornito con il programma</translation>
    </message>
    <message>
        <source>a preset &apos;{label}&apos; comes with the program</source>
        <translation>un preset &apos;{label}&apos; è fornito con il programma</translation>
    </message>
    <message>
        <source>a preset needs a name</source>
        <translation>un preset richiede un nome</translation>
    </message>
    <message>
        <source>add supports, make sparse infill denser, rotate the part, or choose mode auto</source>
        <translation>aggiungi supporti, infittisci il riempimento rado, ruota il pezzo, o scegli il modo auto</translation>
    </message>
    <message>
        <source>choose a smaller dovetail, another direction or another plane</source>
        <translation>scegli una coda di rondine più piccola, un&apos;altra direzione o un altro piano</translation>
    </message>
    <message>
        <source>choose a smaller pin or another plane</source>
        <translation>scegli un perno più piccolo o un altro piano</translation>
    </message>
    <message>
        <source>choose another folder, or check the space on the disk</source>
        <translation>scegli un&apos;altra cartella, o controlla lo spazio su disco</translation>
    </message>
    <message>
        <source>drawing the film</source>
        <translation>disegno del filmato</translation>
    </message>
    <message>
        <source>format {format} has no command for {event}</source>
        <translation>il formato {format} non ha un comando per {event}</translation>
    </message>
    <message>
        <source>give numbers, such as 12, 40</source>
        <translation>indica numeri, come 12, 40</translation>
    </message>
    <message>
        <source>import the parent first, or name another one</source>
        <translation>importa prima il genitore, o indicane un altro</translation>
    </message>
    <message>
        <source>in their home poses machines {one} and {two} are too close to each other</source>
        <translation>nelle posizioni di riposo le macchine {one} e {two} sono troppo vicine</translation>
    </message>
    <message>
        <source>infill tool</source>
        <translation>utensile del riempimento</translation>
    </message>
    <message>
        <source>move the plane into the part</source>
        <translation>sposta il piano dentro il pezzo</translation>
    </message>
    <message>
        <source>move them apart, or change a home pose</source>
        <translation>allontanale, o cambia una posizione di riposo</translation>
    </message>
    <message>
        <source>must not be blank</source>
        <translation>non deve essere vuoto</translation>
    </message>
    <message>
        <source>name another parent</source>
        <translation>indica un altro genitore</translation>
    </message>
    <message>
        <source>name it &apos;{id}&apos;</source>
        <translation>chiamalo &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>no platform below the overhang: {area:.3g}</source>
        <translation>nessuna piattaforma sotto lo sbalzo: {area:.3g}</translation>
    </message>
    <message>
        <source>no room in the section for a dovetail of {width}, {height} high</source>
        <translation>nella sezione non c&apos;è spazio per una coda di rondine larga {width} e alta {height}</translation>
    </message>
    <message>
        <source>no room in the section for a pin of {diameter}, {depth} deep</source>
        <translation>nella sezione non c&apos;è spazio per un perno di {diameter}, profondo {depth}</translation>
    </message>
    <message>
        <source>pauses before layers</source>
        <translation>pause prima degli strati</translation>
    </message>
    <message>
        <source>preset &apos;{id}&apos; is its own parent, through its parents</source>
        <translation>il preset &apos;{id}&apos; è genitore di sé stesso, attraverso i suoi genitori</translation>
    </message>
    <message>
        <source>repair the part, or move the plane</source>
        <translation>ripara il pezzo, o sposta il piano</translation>
    </message>
    <message>
        <source>small contact with the plate: {foot:.3g}; uncut, the part has {whole:.3g#}</source>
        <translation>piccolo contatto con il piano: {foot:.3g}; non tagliato, il pezzo ha {whole:.3g#}</translation>
    </message>
    <message>
        <source>support tool</source>
        <translation>utensile dei supporti</translation>
    </message>
    <message>
        <source>the bead below is covered after {time:.1f}, before the minimum layer time of {limit:.1f}; on {length:.0f} of beads in all</source>
        <translation>il cordone sottostante è coperto dopo {time:.1f}, prima del tempo minimo di strato di {limit:.1f}; in tutto su {length:.0f} di cordoni</translation>
    </message>
    <message>
        <source>the cutter cuts into the fixture below the block</source>
        <translation>la fresa taglia nel supporto sotto il blocco</translation>
    </message>
    <message>
        <source>the film cannot be written</source>
        <translation>il filmato non può essere scritto</translation>
    </message>
    <message>
        <source>the id &apos;{id}&apos; is not the name of the file</source>
        <translation>l&apos;id &apos;{id}&apos; non è il nome del file</translation>
    </message>
    <message>
        <source>the joint cannot be cut out of this mesh</source>
        <translation>l&apos;incastro non può essere tagliato da questa mesh</translation>
    </message>
    <message>
        <source>the parent &apos;{parent}&apos; of preset &apos;{id}&apos; does not exist</source>
        <translation>il genitore &apos;{parent}&apos; del preset &apos;{id}&apos; non esiste</translation>
    </message>
    <message>
        <source>the plane does not cut the part</source>
        <translation>il piano non taglia il pezzo</translation>
    </message>
    <message>
        <source>there is a preset &apos;{label}&apos; already</source>
        <translation>esiste già un preset &apos;{label}&apos;</translation>
    </message>
    <message>
        <source>type a name</source>
        <translation>scrivi un nome</translation>
    </message>
    <message>
        <source>unknown preset &apos;{id}&apos;</source>
        <translation>preset &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>use a smaller cutter or a smaller stepover, or rotate the part</source>
        <translation>usa una fresa più piccola o un passo laterale minore, o ruota il pezzo</translation>
    </message>
    <message>
        <source>x,y,z in the part&apos;s file, for example 1,0,0: reports the strength for a load in this direction. Empty: no load.</source>
        <translation>x,y,z nel file del pezzo, per esempio 1,0,0: riporta la resistenza per un carico in questa direzione. Vuoto: nessun carico.</translation>
    </message>
    <message>
        <source>the film cannot be written: FFmpeg has no encoder for VP9</source>
        <translation>il filmato non può essere scritto: FFmpeg non ha un codificatore VP9</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; inherits from &apos;{parent}&apos;, which does not exist</source>
        <translation>&apos;{id}&apos; eredita da &apos;{parent}&apos;, che non esiste</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; inherits from itself, through its parents</source>
        <translation>&apos;{id}&apos; eredita da sé stesso, attraverso i suoi genitori</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is incomplete</source>
        <translation>&apos;{text}&apos; è incompleto</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not an event of a layer</source>
        <translation>&apos;{text}&apos; non è un evento di uno strato</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: {field} {number} is out of range</source>
        <translation>&apos;{text}&apos;: {field} {number} è fuori dall&apos;intervallo</translation>
    </message>
    <message>
        <source>At a stop the pendant shows no text: the controller sends it to the sender of the frames, which has to show it.</source>
        <translation>A una sosta il pannello di comando non mostra testo: il controllore lo invia al mittente dei pacchetti, che deve mostrarlo.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Parallelepipedo</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Asporta</translation>
    </message>
    <message>
        <source>Cylinder along Z</source>
        <translation>Cilindro lungo Z</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondità</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Direzione X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Direzione Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Direzione Z</translation>
    </message>
    <message>
        <source>Flat layers along a direction</source>
        <translation>Strati piani lungo una direzione</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Da</translation>
    </message>
    <message>
        <source>Height (Z)</source>
        <translation>Altezza (Z)</translation>
    </message>
    <message>
        <source>Layers along the surface</source>
        <translation>Strati lungo la superficie</translation>
    </message>
    <message>
        <source>Layers around the rest</source>
        <translation>Strati attorno al resto</translation>
    </message>
    <message>
        <source>Layers that turn to a direction</source>
        <translation>Strati che girano verso una direzione</translation>
    </message>
    <message>
        <source>Middle X</source>
        <translation>Centro X</translation>
    </message>
    <message>
        <source>Middle Y</source>
        <translation>Centro Y</translation>
    </message>
    <message>
        <source>Middle Z</source>
        <translation>Centro Z</translation>
    </message>
    <message>
        <source>Numbers of layers of the part, separated by commas: before each of them the arm goes beside the part and waits until the operator continues, for example to put in an insert. Then it primes the nozzle there.</source>
        <translation>Numeri di strati del pezzo separati da virgole: prima di ciascuno il braccio va accanto al pezzo e attende che l&apos;operatore continui, per esempio per inserire un elemento. Poi esegue lì l&apos;innesco dell&apos;ugello.</translation>
    </message>
    <message>
        <source>Own settings</source>
        <translation>Impostazioni proprie</translation>
    </message>
    <message>
        <source>Painted surface</source>
        <translation>Superficie dipinta</translation>
    </message>
    <message>
        <source>Pauses before layers</source>
        <translation>Pause prima degli strati</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>Range of heights over the plate</source>
        <translation>Intervallo di altezze sopra il piatto</translation>
    </message>
    <message>
        <source>Skin below the upper surface</source>
        <translation>Pelle sotto la superficie superiore</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sfera</translation>
    </message>
    <message>
        <source>Steepest slope (degrees)</source>
        <translation>Pendenza massima (gradi)</translation>
    </message>
    <message>
        <source>To</source>
        <translation>A</translation>
    </message>
    <message>
        <source>a change of colour</source>
        <translation>un cambio di colore</translation>
    </message>
    <message>
        <source>a change to extruder {number}</source>
        <translation>un cambio all&apos;estrusore {number}</translation>
    </message>
    <message>
        <source>a painted fuzzy skin</source>
        <translation>una superficie ruvida dipinta</translation>
    </message>
    <message>
        <source>a painted seam</source>
        <translation>una cucitura dipinta</translation>
    </message>
    <message>
        <source>a pause</source>
        <translation>una pausa</translation>
    </message>
    <message>
        <source>a spiral has no regions</source>
        <translation>una spirale non ha regioni</translation>
    </message>
    <message>
        <source>a statement of your own</source>
        <translation>un&apos;istruzione propria</translation>
    </message>
    <message>
        <source>a tool changes before a layer, not at a height</source>
        <translation>un utensile si cambia prima di uno strato, non a un&apos;altezza</translation>
    </message>
    <message>
        <source>add it from its file again</source>
        <translation>aggiungila di nuovo dal suo file</translation>
    </message>
    <message>
        <source>change the tool where the file was made</source>
        <translation>cambia l&apos;utensile dove è stato creato il file</translation>
    </message>
    <message>
        <source>check what it does on the controller; leave it out of `layerEvents` if you do not need it</source>
        <translation>controlla che cosa fa sul controllore; toglila da `layerEvents` se non serve</translation>
    </message>
    <message>
        <source>choose a process without corrections, or remove the regions</source>
        <translation>scegli un processo senza correzioni, o rimuovi le regioni</translation>
    </message>
    <message>
        <source>correct the setting; layers are counted for each part</source>
        <translation>correggi l&apos;impostazione; gli strati si contano per ogni pezzo</translation>
    </message>
    <message>
        <source>custom G-code</source>
        <translation>G-code personalizzato</translation>
    </message>
    <message>
        <source>event</source>
        <translation>evento</translation>
    </message>
    <message>
        <source>events before layers</source>
        <translation>eventi prima degli strati</translation>
    </message>
    <message>
        <source>format {format} has outputs {first} to {last}, not {number}</source>
        <translation>il formato {format} ha le uscite da {first} a {last}, non {number}</translation>
    </message>
    <message>
        <source>give a steeper slope</source>
        <translation>dai una pendenza maggiore</translation>
    </message>
    <message>
        <source>give a tilted direction</source>
        <translation>indica una direzione inclinata</translation>
    </message>
    <message>
        <source>give the lower height first</source>
        <translation>dai prima l&apos;altezza minore</translation>
    </message>
    <message>
        <source>give the number of the layer</source>
        <translation>indica il numero dello strato</translation>
    </message>
    <message>
        <source>give {field} from {least} to {most}</source>
        <translation>dai {field} da {least} a {most}</translation>
    </message>
    <message>
        <source>height {height}</source>
        <translation>altezza {height}</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>non è un oggetto JSON</translation>
    </message>
    <message>
        <source>layers of region {region} turn to a vertical direction</source>
        <translation>gli strati della regione {region} ruotano verso una direzione verticale</translation>
    </message>
    <message>
        <source>layers that turn by {angle} within the region are {thin:.2f} to {thick:.2f} thick, outside the limits</source>
        <translation>strati che girano di {angle} entro la regione sono spessi da {thin:.2f} a {thick:.2f}, fuori dai limiti</translation>
    </message>
    <message>
        <source>line {line}: the print pauses before bead {bead} in layer {layer}: {text} ({command})</source>
        <translation>riga {line}: la stampa fa una pausa prima del cordone {bead} nello strato {layer}: {text} ({command})</translation>
    </message>
    <message>
        <source>make it deeper, or use a process with lower layers</source>
        <translation>rendila più profonda, o usa un processo con strati più bassi</translation>
    </message>
    <message>
        <source>make the region higher or narrower, or turn by less</source>
        <translation>rendi la regione più alta o più stretta, o gira di meno</translation>
    </message>
    <message>
        <source>make the region smaller</source>
        <translation>rimpicciolisci la regione</translation>
    </message>
    <message>
        <source>make the region smaller, or move it</source>
        <translation>rimpicciolisci la regione, o spostala</translation>
    </message>
    <message>
        <source>make the regions smaller, or move them up</source>
        <translation>rimpicciolisci le regioni, o spostale verso l&apos;alto</translation>
    </message>
    <message>
        <source>mode {mode} prints on the part: it has no regions</source>
        <translation>la modalità {mode} stampa sul pezzo: non ha regioni</translation>
    </message>
    <message>
        <source>move the plane further into the part</source>
        <translation>sposta il piano più all&apos;interno del pezzo</translation>
    </message>
    <message>
        <source>move the plane into a body, or split the part into its bodies</source>
        <translation>sposta il piano dentro un corpo, o separa il pezzo nei suoi corpi</translation>
    </message>
    <message>
        <source>no change of the tool before layer {layer}: the part has {layers} layers</source>
        <translation>nessun cambio utensile prima dello strato {layer}: il pezzo ha {layers} strati</translation>
    </message>
    <message>
        <source>no {what} before {place} of part {part}: the part has {layers} layers</source>
        <translation>{what} impossibile prima di {place} del pezzo {part}: il pezzo ha {layers} strati</translation>
    </message>
    <message>
        <source>no {what} before {place}: the print ends with layer {layers}</source>
        <translation>{what} impossibile prima di {place}: la stampa finisce con lo strato {layers}</translation>
    </message>
    <message>
        <source>nobody but you knows what the statement is for</source>
        <translation>solo tu sai a che cosa serve l&apos;istruzione</translation>
    </message>
    <message>
        <source>not used, as they are damaged: {what} (&apos;{member}&apos;): {why}</source>
        <translation>non usati perché danneggiati: {what} (&apos;{member}&apos;): {why}</translation>
    </message>
    <message>
        <source>not used: invalid settings of region &apos;{region}&apos; from the file: {settings}</source>
        <translation>non usate: impostazioni non valide della regione &apos;{region}&apos; del file: {settings}</translation>
    </message>
    <message>
        <source>not used: region &apos;{region}&apos; from the file, which has no settings</source>
        <translation>non usata: la regione &apos;{region}&apos; del file, che non ha impostazioni</translation>
    </message>
    <message>
        <source>not used: region &apos;{region}&apos; from the file: its mesh is not closed</source>
        <translation>non usata: la regione &apos;{region}&apos; del file: la sua mesh non è chiusa</translation>
    </message>
    <message>
        <source>not used: settings of ranges of height (&apos;{member}&apos;)</source>
        <translation>non usate: impostazioni di intervalli di altezza (&apos;{member}&apos;)</translation>
    </message>
    <message>
        <source>not used: settings of ranges of height of object {number}, which does not exist (&apos;{member}&apos;)</source>
        <translation>non usate: impostazioni di intervalli di altezza dell&apos;oggetto {number}, che non esiste (&apos;{member}&apos;)</translation>
    </message>
    <message>
        <source>not used: settings of ranges of height: the objects of the file are one part</source>
        <translation>non usate: impostazioni di intervalli di altezza: gli oggetti del file sono un solo pezzo</translation>
    </message>
    <message>
        <source>not used: settings of region &apos;{region}&apos; from the file without a counterpart: {settings}</source>
        <translation>non usate: impostazioni della regione &apos;{region}&apos; del file senza corrispondenza: {settings}</translation>
    </message>
    <message>
        <source>not used: the range of heights from {from} to {to} in the file, which is empty</source>
        <translation>non usato: l&apos;intervallo di altezze da {from} a {to} del file, che è vuoto</translation>
    </message>
    <message>
        <source>not used: tool {tool} of region &apos;{region}&apos; from the file: the job has {tools}</source>
        <translation>non usato: utensile {tool} della regione &apos;{region}&apos; del file: il lavoro ne ha {tools}</translation>
    </message>
    <message>
        <source>not used: {count} further events at heights (&apos;{member}&apos;)</source>
        <translation>non usati: altri {count} eventi ad altezze (&apos;{member}&apos;)</translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} further regions of the file</source>
        <translation>
            <numerusform>non usata: {count} altra regione del file</numerusform>
            <numerusform>non usate: altre {count} regioni del file</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} stops before the first bead, since programs begin with a question</source>
        <translation>
            <numerusform>non usato: {count} arresto prima del primo cordone, poiché i programmi iniziano con una domanda</numerusform>
            <numerusform>non usati: {count} arresti prima del primo cordone, poiché i programmi iniziano con una domanda</numerusform>
        </translation>
    </message>
    <message>
        <source>not used: {event} at a height of {height} (&apos;{member}&apos;)</source>
        <translation>non usato: {event} a un&apos;altezza di {height} (&apos;{member}&apos;)</translation>
    </message>
    <message numerus="yes">
        <source>not used: {paint} on {count} triangles of &apos;{object}&apos; ({attribute}, from line {line} of {where})</source>
        <translation>
            <numerusform>non usato: {paint} su {count} triangolo di &apos;{object}&apos; ({attribute}, dalla riga {line} di {where})</numerusform>
            <numerusform>non usato: {paint} su {count} triangoli di &apos;{object}&apos; ({attribute}, dalla riga {line} di {where})</numerusform>
        </translation>
    </message>
    <message>
        <source>output {number} is used by the program itself</source>
        <translation>l&apos;uscita {number} è usata dal programma stesso</translation>
    </message>
    <message>
        <source>paint it in the window, or give a body</source>
        <translation>dipingila nella finestra, o dai un corpo</translation>
    </message>
    <message>
        <source>painted colours</source>
        <translation>colori dipinti</translation>
    </message>
    <message>
        <source>painted supports</source>
        <translation>supporti dipinti</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>pausa</translation>
    </message>
    <message>
        <source>presets hold settings of layers, beads, tool-paths, cooling and quality</source>
        <translation>i preset contengono impostazioni di strati, cordoni, percorsi, raffreddamento e qualità</translation>
    </message>
    <message>
        <source>process {process} corrects sizes: layers of regions have no corrections</source>
        <translation>il processo {process} corregge le misure: gli strati delle regioni non hanno correzioni</translation>
    </message>
    <message>
        <source>region</source>
        <translation>regione</translation>
    </message>
    <message>
        <source>region &apos;{region}&apos; from the file: its mesh is open, and was closed</source>
        <translation>regione &apos;{region}&apos; del file: la sua mesh è aperta ed è stata chiusa</translation>
    </message>
    <message>
        <source>region &apos;{region}&apos; from the file: the skin is as thick as the larger one of top and bottom</source>
        <translation>regione &apos;{region}&apos; del file: la pelle ha lo spessore maggiore tra sopra e sotto</translation>
    </message>
    <message numerus="yes">
        <source>region &apos;{region}&apos; from the file: {count} settings</source>
        <translation>
            <numerusform>regione &apos;{region}&apos; del file: {count} impostazione</numerusform>
            <numerusform>regione &apos;{region}&apos; del file: {count} impostazioni</numerusform>
        </translation>
    </message>
    <message>
        <source>region &apos;{text}&apos; has no painted surface</source>
        <translation>la regione &apos;{text}&apos; non ha una superficie dipinta</translation>
    </message>
    <message>
        <source>region &apos;{text}&apos;: &apos;{setting}&apos; is no setting</source>
        <translation>regione &apos;{text}&apos;: &apos;{setting}&apos; non è un&apos;impostazione</translation>
    </message>
    <message>
        <source>region {region} cannot be separated from the part: one of them is not closed or intersects itself</source>
        <translation>la regione {region} non può essere separata dal pezzo: uno dei due non è chiuso o si autointerseca</translation>
    </message>
    <message>
        <source>region {region} contains the whole part: nothing carries its layers</source>
        <translation>la regione {region} contiene tutto il pezzo: nulla ne porta gli strati</translation>
    </message>
    <message>
        <source>region {region} cuts away the whole part</source>
        <translation>la regione {region} asporta tutto il pezzo</translation>
    </message>
    <message>
        <source>region {region} follows no surface: it has no layers of its own</source>
        <translation>la regione {region} non segue alcuna superficie: non ha strati propri</translation>
    </message>
    <message>
        <source>region {region} has no mesh</source>
        <translation>la regione {region} non ha una mesh</translation>
    </message>
    <message>
        <source>region {region} is thinner than the lowest layer ({least})</source>
        <translation>la regione {region} è più sottile dello strato più basso ({least})</translation>
    </message>
    <message>
        <source>region {region}: no face of the part is as flat as that</source>
        <translation>regione {region}: nessuna faccia del pezzo è così piana</translation>
    </message>
    <message>
        <source>regions take away what the part stands on: the rest of it begins {gap:.3g} above its place</source>
        <translation>le regioni tolgono ciò su cui poggia il pezzo: il resto comincia {gap:.3g} sopra il suo posto</translation>
    </message>
    <message>
        <source>remove the regions, or choose another mode</source>
        <translation>togli le regioni, o scegli un&apos;altra modalità</translation>
    </message>
    <message>
        <source>remove the regions, or plan layers of the part (`givenToolPaths=false`)</source>
        <translation>togli le regioni, o pianifica strati del pezzo (`givenToolPaths=false`)</translation>
    </message>
    <message>
        <source>remove the regions, or set spiral to false</source>
        <translation>togli le regioni, oppure imposta spiral su false</translation>
    </message>
    <message>
        <source>repair the part, or move the region a little</source>
        <translation>ripara il pezzo, o sposta un poco la regione</translation>
    </message>
    <message>
        <source>setting an output</source>
        <translation>l&apos;impostazione di un&apos;uscita</translation>
    </message>
    <message>
        <source>settings of a region: {keys}</source>
        <translation>impostazioni di una regione: {keys}</translation>
    </message>
    <message>
        <source>template G-code</source>
        <translation>G-code modello</translation>
    </message>
    <message>
        <source>the body of a region is not closed</source>
        <translation>il corpo di una regione non è chiuso</translation>
    </message>
    <message>
        <source>the plane leaves a slab of {thickness} at {place}, thinner than a layer</source>
        <translation>il piano lascia una lastra di {thickness} in {place}, più sottile di uno strato</translation>
    </message>
    <message>
        <source>the plane passes between the bodies of the part and cuts none</source>
        <translation>il piano passa tra i corpi del pezzo e non ne taglia nessuno</translation>
    </message>
    <message>
        <source>the range of heights from {from} to {to} is empty</source>
        <translation>l&apos;intervallo di altezze da {from} a {to} è vuoto</translation>
    </message>
    <message>
        <source>the statement &apos;{text}&apos; is one of format {wanted}, not of {format}</source>
        <translation>l&apos;istruzione &apos;{text}&apos; è del formato {wanted}, non di {format}</translation>
    </message>
    <message>
        <source>the tool-paths of a file have no regions</source>
        <translation>i percorsi di un file non hanno regioni</translation>
    </message>
    <message>
        <source>the tools of a file&apos;s tool-paths are its own: none changes before a layer</source>
        <translation>gli utensili dei percorsi di un file sono i suoi: nessuno cambia prima di uno strato</translation>
    </message>
    <message>
        <source>unknown parameter {key}</source>
        <translation>parametro {key} sconosciuto</translation>
    </message>
    <message>
        <source>unknown parent &apos;{id}&apos;</source>
        <translation>genitore &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown region &apos;{name}&apos;</source>
        <translation>regione &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown use &apos;{name}&apos; of a region</source>
        <translation>uso &apos;{name}&apos; di una regione sconosciuto</translation>
    </message>
    <message>
        <source>unsupported voxels in flat layers: {missed} of {voxels} ({share:.1f}); no layer below carries them</source>
        <translation>voxel non sostenuti in strati piani: {missed} di {voxels} ({share:.1f}); nessuno strato sottostante li porta</translation>
    </message>
    <message>
        <source>use &apos;{text}&apos; of a region has no direction</source>
        <translation>l&apos;uso &apos;{text}&apos; di una regione non ha direzione</translation>
    </message>
    <message>
        <source>use another output</source>
        <translation>usa un&apos;altra uscita</translation>
    </message>
    <message>
        <source>write {form}, lengths in mm</source>
        <translation>scrivi {form}, lunghezze in mm</translation>
    </message>
    <message>
        <source>your own statement, which nothing checks: {statement}</source>
        <translation>istruzione propria, che nulla controlla: {statement}</translation>
    </message>
    <message>
        <source>{key} is a setting of the part, not of a region</source>
        <translation>{key} è un&apos;impostazione del pezzo, non di una regione</translation>
    </message>
    <message>
        <source>{name}; changed: {settings}</source>
        <translation>{name}; modificate: {settings}</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Regione</translation>
    </message>
    <message>
        <source>&apos;{code}&apos; is missing before the line: it would run ahead of the arm</source>
        <translation>&apos;{code}&apos; manca prima della riga: verrebbe eseguita prima che il braccio arrivi</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; has characters that controllers do not know</source>
        <translation>&apos;{text}&apos; ha caratteri che i controllori non conoscono</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: a pause&apos;s text has at most {limit} characters</source>
        <translation>&apos;{text}&apos;: il testo di una pausa ha al massimo {limit} caratteri</translation>
    </message>
    <message>
        <source>a stop shows no text</source>
        <translation>un arresto non mostra alcun testo</translation>
    </message>
    <message>
        <source>shorten the text</source>
        <translation>accorcia il testo</translation>
    </message>
    <message>
        <source>write English letters, digits and signs; in a pause&apos;s text no quotes</source>
        <translation>usa lettere inglesi, cifre e segni; nel testo di una pausa niente virgolette</translation>
    </message>
    <message numerus="yes">
        <source>{waits} pauses and waits above the part: the arm reaches no place beside it, nothing is primed, and material may drip on the part</source>
        <translation>
            <numerusform>{waits} pausa o attesa sopra il pezzo: il braccio non raggiunge alcun posto accanto ad esso, nulla viene preparato, e sul pezzo può gocciolare materiale</numerusform>
            <numerusform>{waits} pause e attese sopra il pezzo: il braccio non raggiunge alcun posto accanto ad esso, nulla viene preparato, e sul pezzo può gocciolare materiale</numerusform>
        </translation>
    </message>
    <message>
        <source>a text is shown without a stop</source>
        <translation>un testo viene mostrato senza un arresto</translation>
    </message>
    <message>
        <source>a module that reads G-code has no commands for stops, waits, tools and outputs</source>
        <translation>un modulo che legge G-code non ha comandi per arresti, attese, utensili e uscite</translation>
    </message>
    <message>
        <source>give the cell a place for purges or a home pose beside the plate, or move the part on the plate</source>
        <translation>dai alla cella un punto di spurgo o una posizione di riposo accanto al piatto, o sposta il pezzo sul piatto</translation>
    </message>
    <message>
        <source>&apos;Close&apos; is missing behind the text</source>
        <translation>&apos;Close&apos; manca dopo il testo</translation>
    </message>
    <message>
        <source>&apos;Close&apos; without its &apos;Open&apos; before it</source>
        <translation>&apos;Close&apos; senza il suo &apos;Open&apos; prima</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; between PVTEnter and PVTExit</source>
        <translation>&apos;{name}&apos; tra PVTEnter e PVTExit</translation>
    </message>
    <message>
        <source>&apos;{part}&apos; is no point of a curve</source>
        <translation>&apos;{part}&apos; non è un punto di una curva</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; in the statement &apos;{text}&apos; {effect}</source>
        <translation>&apos;{word}&apos; nell&apos;istruzione &apos;{text}&apos; {effect}</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; in the statement before {place}, &apos;{text}&apos;, {effect}</source>
        <translation>&apos;{word}&apos; nell&apos;istruzione prima di {place}, &apos;{text}&apos;, {effect}</translation>
    </message>
    <message>
        <source>Across
layers MPa</source>
        <translation>Tra gli
strati MPa</translation>
    </message>
    <message>
        <source>Add a skin</source>
        <translation>Aggiungi una pelle</translation>
    </message>
    <message>
        <source>Along
stress %</source>
        <translation>Lungo le
tensioni %</translation>
    </message>
    <message>
        <source>Break-away columns below overhangs beyond the overhang angle, in mode curved below voxels that growth would miss. A region without them blocks them.</source>
        <translation>Colonne da staccare sotto gli sbalzi oltre l&apos;angolo di sbalzo, nel modo curved sotto i voxel che la crescita mancherebbe. Una regione senza colonne le blocca.</translation>
    </message>
    <message>
        <source>Deflec-
tion mm</source>
        <translation>Infles-
sione mm</translation>
    </message>
    <message>
        <source>Factor of the speed of the part&apos;s beads, within the flow of the extruder and the speed of bridges.</source>
        <translation>Fattore della velocità dei cordoni del pezzo, entro il flusso dell&apos;estrusore e la velocità dei ponti.</translation>
    </message>
    <message>
        <source>For infill along a field: a direction x,y,z, or x,y,z,dx,dy,dz in mm on the plate, separated by spaces or lines, or a file of them. Empty: along the stress between regions that hold the part and regions with a force.</source>
        <translation>Per il riempimento lungo un campo: una direzione x,y,z, oppure x,y,z,dx,dy,dz in mm sul piatto, separati da spazi o righe, o un file di questi. Vuoto: lungo le tensioni tra le regioni che tengono il pezzo e le regioni con una forza.</translation>
    </message>
    <message>
        <source>Force X</source>
        <translation>Forza X</translation>
    </message>
    <message>
        <source>Force Y</source>
        <translation>Forza Y</translation>
    </message>
    <message>
        <source>Force Z</source>
        <translation>Forza Z</translation>
    </message>
    <message>
        <source>Force on the part</source>
        <translation>Forza sul pezzo</translation>
    </message>
    <message>
        <source>Held under load</source>
        <translation>Tenuto fermo sotto carico</translation>
    </message>
    <message>
        <source>In a region: closed beads that pass through it begin there, or never do if they can begin elsewhere.</source>
        <translation>In una regione: i cordoni chiusi che la attraversano iniziano lì, oppure mai se possono iniziare altrove.</translation>
    </message>
    <message>
        <source>In flat layers the region reaches half of it into the part around it, in every other layer the part reaches as far into the region, so that both hold each other.</source>
        <translation>Negli strati piani la regione entra per metà di questo valore nel pezzo attorno; uno strato sì e uno no è il pezzo a entrare altrettanto nella regione, così i due si tengono a vicenda.</translation>
    </message>
    <message>
        <source>Region {number}</source>
        <translation>Regione {number}</translation>
    </message>
    <message>
        <source>Safe to run but for your own statements, which nothing checks.</source>
        <translation>Sicuro da eseguire, salvo le istruzioni proprie, che nulla controlla.</translation>
    </message>
    <message>
        <source>Three curved layers along the upper surface, over the flat ones</source>
        <translation>Tre strati curvi lungo la superficie superiore, sopra quelli piani</translation>
    </message>
    <message>
        <source>What happens before layers of the part, separated by semicolons. Each begins with a layer (12) or a height in mm (z5.5): 12 pause TEXT; 20 wait SECONDS; 30 output NUMBER on; 35 photo OUTPUT SECONDS; 40 tool NUMBER; 50 statement FORMAT LINE.</source>
        <translation>Che cosa succede prima di strati del pezzo, separato da punti e virgola. Ogni voce inizia con uno strato (12) o un&apos;altezza in mm (z5.5): 12 pause TESTO; 20 wait SECONDI; 30 output NUMERO on; 35 photo USCITA SECONDI; 40 tool NUMERO; 50 statement FORMATO RIGA.</translation>
    </message>
    <message>
        <source>a line for a wait differs from the line before in its last number</source>
        <translation>la riga di un&apos;attesa differisce dalla riga precedente nell&apos;ultimo numero</translation>
    </message>
    <message>
        <source>a region with a force contains nothing of the part that is held</source>
        <translation>una regione con una forza non contiene nulla del pezzo che è tenuto fermo</translation>
    </message>
    <message>
        <source>a skin of layers along the surface has none</source>
        <translation>una pelle di strati lungo la superficie non ne ha</translation>
    </message>
    <message>
        <source>a statement of your own sets &apos;{name}&apos;, which the program uses itself</source>
        <translation>un&apos;istruzione propria imposta &apos;{name}&apos;, che il programma stesso usa</translation>
    </message>
    <message>
        <source>add a second region of that shape for its settings</source>
        <translation>aggiungi una seconda regione di quella forma per le sue impostazioni</translation>
    </message>
    <message>
        <source>along a field</source>
        <translation>lungo un campo</translation>
    </message>
    <message>
        <source>always</source>
        <translation>sempre</translation>
    </message>
    <message>
        <source>changes a temperature</source>
        <translation>modifica una temperatura</translation>
    </message>
    <message>
        <source>changes the extruder</source>
        <translation>modifica l&apos;estrusore</translation>
    </message>
    <message>
        <source>changes the order of the program&apos;s lines</source>
        <translation>modifica l&apos;ordine delle righe del programma</translation>
    </message>
    <message>
        <source>changes the origin, the tool or the units</source>
        <translation>modifica l&apos;origine, l&apos;utensile o le unità</translation>
    </message>
    <message>
        <source>deflection under the forces</source>
        <translation>inflessione sotto le forze</translation>
    </message>
    <message>
        <source>field of the infill</source>
        <translation>campo del riempimento</translation>
    </message>
    <message>
        <source>found no equilibrium of the part under its load</source>
        <translation>non trovato alcun equilibrio del pezzo sotto il suo carico</translation>
    </message>
    <message>
        <source>from the file: {event} at a height of {height}</source>
        <translation>dal file: {event} a un&apos;altezza di {height}</translation>
    </message>
    <message>
        <source>give a direction x,y,z or samples x,y,z,dx,dy,dz, or the part regions that hold it and regions with a force</source>
        <translation>dai una direzione x,y,z o campioni x,y,z,dx,dy,dz, oppure al pezzo regioni che lo tengono e regioni con una forza</translation>
    </message>
    <message>
        <source>give a region where the part is fixed the use &apos;hold&apos;</source>
        <translation>dai l&apos;uso &apos;hold&apos; a una regione in cui il pezzo è fissato</translation>
    </message>
    <message>
        <source>give it as a skin or a painted surface, or use it for settings</source>
        <translation>dalla come pelle o superficie dipinta, o usala per impostazioni</translation>
    </message>
    <message>
        <source>give, for example, 12 pause; 20 pause Put in the nut; z5.5 wait 60; 30 output 3 on; 35 photo 4 0.5; 40 tool 2; 50 statement urscript LINE</source>
        <translation>indica, per esempio, 12 pause; 20 pause Inserisci il dado; z5.5 wait 60; 30 output 3 on; 35 photo 4 0.5; 40 tool 2; 50 statement urscript RIGA</translation>
    </message>
    <message>
        <source>hold the part in more places</source>
        <translation>tieni fermo il pezzo in più punti</translation>
    </message>
    <message>
        <source>infill along the stress</source>
        <translation>riempimento lungo le tensioni</translation>
    </message>
    <message>
        <source>interlock of a region</source>
        <translation>incastro di una regione</translation>
    </message>
    <message>
        <source>is above &apos;alongMPa&apos;</source>
        <translation>è maggiore di &apos;alongMPa&apos;</translation>
    </message>
    <message>
        <source>is above {limit}</source>
        <translation>è maggiore di {limit}</translation>
    </message>
    <message>
        <source>leave it out: the plan moves the arm</source>
        <translation>toglila: è il piano a muovere il braccio</translation>
    </message>
    <message>
        <source>machine {machine} is {verdict}: {reason}</source>
        <translation>la macchina {machine} è {verdict}: {reason}</translation>
    </message>
    <message>
        <source>move it into the part, paint it, or remove it</source>
        <translation>spostala dentro il pezzo, dipingila, o rimuovila</translation>
    </message>
    <message>
        <source>move it onto the part, or make it larger</source>
        <translation>spostala sul pezzo, o ingrandiscila</translation>
    </message>
    <message>
        <source>move them onto the part, or make them larger</source>
        <translation>spostale sul pezzo, o ingrandiscile</translation>
    </message>
    <message>
        <source>moves the arm, or changes how it moves</source>
        <translation>muove il braccio, o modifica il modo in cui si muove</translation>
    </message>
    <message>
        <source>never</source>
        <translation>mai</translation>
    </message>
    <message numerus="yes">
        <source>not used, as it is damaged: {paint} on {count} triangles of &apos;{object}&apos; ({attribute}, {where})</source>
        <translation>
            <numerusform>non usato, perché danneggiato: {paint} su {count} triangolo di &apos;{object}&apos; ({attribute}, {where})</numerusform>
            <numerusform>non usato, perché danneggiato: {paint} su {count} triangoli di &apos;{object}&apos; ({attribute}, {where})</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} stops behind the last bead, where the print is done</source>
        <translation>
            <numerusform>non usato: {count} arresto dopo l&apos;ultimo cordone, dove la stampa è finita</numerusform>
            <numerusform>non usati: {count} arresti dopo l&apos;ultimo cordone, dove la stampa è finita</numerusform>
        </translation>
    </message>
    <message>
        <source>not used: {event} at a height of {height} in the file: the part ends at {top}</source>
        <translation>non usato: {event} a un&apos;altezza di {height} nel file: il pezzo finisce a {top}</translation>
    </message>
    <message>
        <source>nothing of the part is within the regions that hold it</source>
        <translation>nulla del pezzo è entro le regioni che lo tengono</translation>
    </message>
    <message>
        <source>paint whole faces</source>
        <translation>dipingi facce intere</translation>
    </message>
    <message>
        <source>put it into a routine on the controller, and call that</source>
        <translation>mettila in una routine sul controllore, e richiama quella</translation>
    </message>
    <message>
        <source>region {region} asks for supports, which mode {mode} does not have</source>
        <translation>la regione {region} chiede supporti, che la modalità {mode} non ha</translation>
    </message>
    <message>
        <source>region {region} asks for supports: its own layers have none</source>
        <translation>la regione {region} chiede supporti: i suoi strati propri non ne hanno</translation>
    </message>
    <message>
        <source>region {region} carries the load: it has no settings</source>
        <translation>la regione {region} porta il carico: non ha impostazioni</translation>
    </message>
    <message>
        <source>region {region} is outside the part, behind later regions, or not painted: it has no effect</source>
        <translation>la regione {region} è fuori dal pezzo, dietro regioni successive, o non dipinta: non ha effetto</translation>
    </message>
    <message>
        <source>region {region}: half of no face of the part is painted</source>
        <translation>regione {region}: nessuna faccia del pezzo è dipinta almeno per metà</translation>
    </message>
    <message>
        <source>safe to run but for its own statements, which nothing checks</source>
        <translation>sicura da eseguire, salvo le sue istruzioni proprie, che nulla controlla</translation>
    </message>
    <message>
        <source>safe to run, but does not print its part as asked</source>
        <translation>sicura da eseguire, ma non stampa il suo pezzo come richiesto</translation>
    </message>
    <message>
        <source>seam here</source>
        <translation>giunzione qui</translation>
    </message>
    <message>
        <source>set `supports=none` for the region, or choose another mode</source>
        <translation>imposta `supports=none` per la regione, o scegli un&apos;altra modalità</translation>
    </message>
    <message>
        <source>set it in the cell before the program starts</source>
        <translation>impostalo nella cella prima che il programma inizi</translation>
    </message>
    <message>
        <source>set it in the process</source>
        <translation>impostalo nel processo</translation>
    </message>
    <message>
        <source>set the temperatures of the material</source>
        <translation>imposta le temperature del materiale</translation>
    </message>
    <message>
        <source>sets an output</source>
        <translation>imposta un&apos;uscita</translation>
    </message>
    <message>
        <source>speed factor</source>
        <translation>fattore di velocità</translation>
    </message>
    <message>
        <source>stops or ends the program</source>
        <translation>ferma o termina il programma</translation>
    </message>
    <message>
        <source>tension across layers</source>
        <translation>trazione tra gli strati</translation>
    </message>
    <message>
        <source>there are regions with a force, but none that holds the part</source>
        <translation>ci sono regioni con una forza, ma nessuna che tiene il pezzo</translation>
    </message>
    <message>
        <source>there is no field of directions for the infill</source>
        <translation>non c&apos;è un campo di direzioni per il riempimento</translation>
    </message>
    <message>
        <source>under all overhangs</source>
        <translation>sotto tutti gli sbalzi</translation>
    </message>
    <message>
        <source>use another name</source>
        <translation>usa un altro nome</translation>
    </message>
    <message>
        <source>{share:.0f} of the surface are gentle slopes with steps of {mean:.2g} on average</source>
        <translation>il {share:.0f} della superficie è in lieve pendenza, con gradini di {mean:.2g} in media</translation>
    </message>
    <message>
        <source>a force acts only where the part is held</source>
        <translation>una forza agisce solo dove il pezzo è tenuto</translation>
    </message>
    <message>
        <source>infill across the stress</source>
        <translation>riempimento di traverso alla tensione</translation>
    </message>
    <message>
        <source>may do anything: Voluta does not know it</source>
        <translation>può fare qualsiasi cosa: Voluta non lo conosce</translation>
    </message>
    <message>
        <source>move the region with the force away from the one that holds</source>
        <translation>allontana la regione con la forza da quella che tiene</translation>
    </message>
    <message>
        <source>the flow is not 0 while the extruder is off</source>
        <translation>il flusso non è 0 mentre l&apos;estrusore è spento</translation>
    </message>
    <message>
        <source>the part has no volume to be loaded</source>
        <translation>il pezzo non ha volume da caricare</translation>
    </message>
    <message>
        <source>use a region of its own for the supports, whose use is settings</source>
        <translation>usa per i supporti una regione propria, con uso impostazioni</translation>
    </message>
    <message>
        <source>use an event for it, for example 12 pause Put in the nut</source>
        <translation>usa un evento, per esempio 12 pause Put in the nut</translation>
    </message>
    <message>
        <source>use an event for it, for example 30 output 3 on</source>
        <translation>usa un evento, per esempio 30 output 3 on</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is no direction</source>
        <translation>&apos;{text}&apos; non è una direzione</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: {field} &apos;{word}&apos; is not a number</source>
        <translation>&apos;{text}&apos;: {field} &apos;{word}&apos; non è un numero</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: {field} is no whole number</source>
        <translation>&apos;{text}&apos;: {field} non è un numero intero</translation>
    </message>
    <message>
        <source>Before layer (0: automatic)</source>
        <translation>Prima dello strato (0: automatico)</translation>
    </message>
    <message>
        <source>Inserted part</source>
        <translation>Elemento inserito</translation>
    </message>
    <message>
        <source>Searches for a better orientation of the part: with the smallest overhanging area, with the fewest voxels missed by growth, along the axes, so that the projections on XY and XZ leave the least area of their bounding rectangles empty (blanks for milling), with the smallest overhanging area after the part is cut into pieces (mode planar), or with the least tension across the layers under the load of its regions.</source>
        <translation>Cerca un orientamento migliore del pezzo: con la minore area a sbalzo, con il minor numero di voxel mancati dalla crescita, lungo gli assi, così che le proiezioni su XY e XZ lascino vuota la minore area dei loro rettangoli circoscritti (grezzi da fresare), con la minore area a sbalzo dopo il taglio in parti (modo planar), o con la minore trazione tra gli strati sotto il carico delle sue regioni.</translation>
    </message>
    <message>
        <source>`orient=leastTension` needs a region that pushes the part</source>
        <translation>`orient=leastTension` richiede una regione che spinga il pezzo</translation>
    </message>
    <message>
        <source>add a statement for {format} at that place, or use {formats}</source>
        <translation>aggiungi in quel punto un&apos;istruzione per {format}, o usa {formats}</translation>
    </message>
    <message>
        <source>beads lie above its place before the print pauses</source>
        <translation>sopra il suo posto ci sono cordoni prima che la stampa faccia la pausa</translation>
    </message>
    <message>
        <source>beads lie in its place</source>
        <translation>nel suo posto ci sono cordoni</translation>
    </message>
    <message>
        <source>figures</source>
        <translation>i valori</translation>
    </message>
    <message>
        <source>found no equilibrium of the beads</source>
        <translation>non trovato alcun equilibrio dei cordoni</translation>
    </message>
    <message>
        <source>give forces that do not cancel each other</source>
        <translation>indica forze che non si annullino a vicenda</translation>
    </message>
    <message>
        <source>give regions with the uses &apos;hold&apos; and &apos;load&apos;</source>
        <translation>indica regioni con gli usi &apos;hold&apos; e &apos;load&apos;</translation>
    </message>
    <message>
        <source>give three numbers, x,y,z, of which one is not 0</source>
        <translation>dai tre numeri, x,y,z, di cui uno diverso da 0</translation>
    </message>
    <message>
        <source>inserted part</source>
        <translation>elemento inserito</translation>
    </message>
    <message>
        <source>it is narrower than half a bead of {width}</source>
        <translation>è più stretta di mezzo cordone da {width}</translation>
    </message>
    <message>
        <source>it is too thin for a layer of its own</source>
        <translation>è troppo sottile per uno strato proprio</translation>
    </message>
    <message>
        <source>it is too thin to meet a layer</source>
        <translation>è troppo sottile per incontrare uno strato</translation>
    </message>
    <message>
        <source>it stands above the first layer after it, so the head keeps away from it</source>
        <translation>sporge sopra il primo strato successivo, perciò la testina se ne tiene lontana</translation>
    </message>
    <message>
        <source>its interlock of {width} reaches through it in {crossed} of {layers} layers</source>
        <translation>il suo incastro di {width} la attraversa da parte a parte in {crossed} strati su {layers}</translation>
    </message>
    <message>
        <source>later regions hold in all of it</source>
        <translation>ovunque in essa valgono regioni successive</translation>
    </message>
    <message>
        <source>layers along given planes have no supports: those asked for are left out</source>
        <translation>gli strati lungo piani dati non hanno supporti: quelli richiesti sono omessi</translation>
    </message>
    <message>
        <source>least tension across layers</source>
        <translation>minore trazione tra gli strati</translation>
    </message>
    <message>
        <source>make it larger, or the layers thinner</source>
        <translation>falla più grande, o gli strati più sottili</translation>
    </message>
    <message>
        <source>make it wider, or use a finer nozzle</source>
        <translation>falla più larga, o usa un ugello più fine</translation>
    </message>
    <message>
        <source>material {material} states no elasticity</source>
        <translation>il materiale {material} non indica l&apos;elasticità</translation>
    </message>
    <message>
        <source>move it down the list of regions</source>
        <translation>spostala più in basso nell&apos;elenco delle regioni</translation>
    </message>
    <message>
        <source>no bead is under stress</source>
        <translation>nessun cordone è sotto tensione</translation>
    </message>
    <message>
        <source>no effect of region {region}: {reason}</source>
        <translation>la regione {region} non ha effetto: {reason}</translation>
    </message>
    <message>
        <source>nothing is below it when the print pauses</source>
        <translation>sotto non ha nulla quando la stampa fa la pausa</translation>
    </message>
    <message>
        <source>nothing is printed after it: the print does not pause for it</source>
        <translation>dopo di esso non si stampa nulla: la stampa non fa una pausa per esso</translation>
    </message>
    <message>
        <source>remove `layerPlanes`, or set `supports=none`</source>
        <translation>togli `layerPlanes`, o imposta `supports=none`</translation>
    </message>
    <message>
        <source>run it on the controller if the rest needs it</source>
        <translation>eseguila sul controllore se il resto ne ha bisogno</translation>
    </message>
    <message>
        <source>set a smaller `interlockMm`, or make the region larger</source>
        <translation>imposta un `interlockMm` minore, o fai la regione più grande</translation>
    </message>
    <message>
        <source>stiffness and tensions</source>
        <translation>rigidezza e trazioni</translation>
    </message>
    <message>
        <source>tape {process} or the plastic around it states no elasticity</source>
        <translation>il nastro {process} o la plastica attorno non indica l&apos;elasticità</translation>
    </message>
    <message numerus="yes">
        <source>the field is perpendicular to {patches} patches of the layers, filled with straight lines</source>
        <translation>
            <numerusform>il campo è perpendicolare a {patches} superficie degli strati, riempita con linee rette</numerusform>
            <numerusform>il campo è perpendicolare a {patches} superfici degli strati, riempite con linee rette</numerusform>
        </translation>
    </message>
    <message>
        <source>the infill is not along a field</source>
        <translation>il riempimento non è lungo un campo</translation>
    </message>
    <message>
        <source>the infill of region {region} is not along a field</source>
        <translation>il riempimento della regione {region} non è lungo un campo</translation>
    </message>
    <message>
        <source>the inserted part {insert} does not fit: {reason}</source>
        <translation>l&apos;elemento inserito {insert} non trova posto: {reason}</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): tension across its layers {tension:.2g} MPa instead of {tensionBefore:.2g}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>il pezzo è stato girato di {angle:.0f} attorno a ({x}, {y}, {z}): trazione tra gli strati {tension:.2g} MPa invece di {tensionBefore:.2g}, sbalzo {overhang:.0f} invece di {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the rest does not run your statement before its beginning: {statement}</source>
        <translation>il resto non esegue la tua istruzione che precede il suo inizio: {statement}</translation>
    </message>
    <message>
        <source>turn the part, or choose another field or infill</source>
        <translation>gira il pezzo, o scegli un altro campo o riempimento</translation>
    </message>
    <message>
        <source>turn the part, or let the region have supports if the overhang sags</source>
        <translation>gira il pezzo, o ammetti supporti nella regione se lo sbalzo cede</translation>
    </message>
    <message>
        <source>unknown {figures} under the forces: {reason}</source>
        <translation>non si conoscono {figures} sotto le forze: {reason}</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs by more than {angle} where regions block supports; here is most of it</source>
        <translation>{area:.3g} sporgono di oltre {angle} dove regioni bloccano i supporti; la maggior parte è qui</translation>
    </message>
    <message>
        <source>give the material its elasticity</source>
        <translation>indica l&apos;elasticità del materiale</translation>
    </message>
    <message>
        <source>give the modulus and the share of its fibres, and the elasticity of the plastic</source>
        <translation>indica il modulo e la quota delle sue fibre, e l&apos;elasticità della plastica</translation>
    </message>
    <message>
        <source>it is thinner than a layer, which leaves no room for it</source>
        <translation>è più sottile di uno strato, che non gli lascia posto</translation>
    </message>
    <message>
        <source>it reaches below the plate</source>
        <translation>arriva sotto il piano</translation>
    </message>
    <message>
        <source>it takes the place of {other}</source>
        <translation>occupa il posto di {other}</translation>
    </message>
    <message>
        <source>move its region on the Prepare page</source>
        <translation>sposta la sua regione nella pagina Prepara</translation>
    </message>
    <message>
        <source>move its region, or choose the layer before which it is put in</source>
        <translation>sposta la sua regione, o scegli lo strato prima del quale viene inserito</translation>
    </message>
    <message>
        <source>no effect of {key}: {reason}</source>
        <translation>{key} non ha effetto: {reason}</translation>
    </message>
    <message>
        <source>set `infill=field`, or remove the field</source>
        <translation>imposta `infill=field`, o togli il campo</translation>
    </message>
</context>
<context>
    <name>EventMarks</name>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Pause: %1</source>
        <translation>Pausa: %1</translation>
    </message>
    <message>
        <source>Wait: %1 s</source>
        <translation>Attesa: %1 s</translation>
    </message>
    <message>
        <source>Output %1 on</source>
        <translation>Uscita %1 accesa</translation>
    </message>
    <message>
        <source>Output %1 off</source>
        <translation>Uscita %1 spenta</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Utensile %1</translation>
    </message>
    <message>
        <source>Before layer %1: %2</source>
        <translation>Prima dello strato %1: %2</translation>
    </message>
</context>
<context>
    <name>Gizmo</name>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>HeadNumbersDialog</name>
    <message>
        <source>Nozzle tip radius</source>
        <translation>Raggio della punta dell&apos;ugello</translation>
    </message>
    <message>
        <source>Cone angle</source>
        <translation>Angolo del cono</translation>
    </message>
    <message>
        <source>Cone height</source>
        <translation>Altezza del cono</translation>
    </message>
    <message>
        <source>Block width</source>
        <translation>Larghezza del blocco</translation>
    </message>
    <message>
        <source>Block height</source>
        <translation>Altezza del blocco</translation>
    </message>
</context>
<context>
    <name>LayerEvents</name>
    <message>
        <source>The next plan pauses before layer %1.</source>
        <translation>Il prossimo piano fa una pausa prima dello strato %1.</translation>
    </message>
    <message>
        <source>The next plan does not pause before layer %1.</source>
        <translation>Il prossimo piano non fa pause prima dello strato %1.</translation>
    </message>
    <message>
        <source>The next plan has the event before layer %1.</source>
        <translation>Il prossimo piano ha l&apos;evento prima dello strato %1.</translation>
    </message>
</context>
<context>
    <name>LegendFigures</name>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Quota</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Travel and waits</source>
        <translation>Spostamenti e attese</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>%1 to %2</source>
        <translation>da %1 a %2</translation>
    </message>
    <message>
        <source>All settings</source>
        <translation>Tutte le impostazioni</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>impostazione</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>significato</translation>
    </message>
    <message>
        <source>range</source>
        <translation>intervallo</translation>
    </message>
    <message>
        <source>default</source>
        <translation>predefinito</translation>
    </message>
    <message>
        <source>key</source>
        <translation>chiave</translation>
    </message>
    <message>
        <source>All findings</source>
        <translation>Tutte le segnalazioni</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>segnalazione</translation>
    </message>
    <message>
        <source>what would help</source>
        <translation>che cosa aiuterebbe</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Indice</translation>
    </message>
    <message>
        <source>Algorithms</source>
        <translation>Algoritmi</translation>
    </message>
</context>
<context>
    <name>MillForm</name>
    <message>
        <source>Cutter diameter</source>
        <translation>Diametro della fresa</translation>
    </message>
    <message>
        <source>The cutter has a round end</source>
        <translation>La fresa ha punta sferica</translation>
    </message>
    <message>
        <source>0: side load of the material; less leaves lower ridges</source>
        <translation>0: passo laterale del materiale; un valore minore lascia creste più basse</translation>
    </message>
    <message>
        <source>by material</source>
        <translation>dal materiale</translation>
    </message>
    <message>
        <source>Roughing depth</source>
        <translation>Profondità di sgrossatura</translation>
    </message>
    <message>
        <source>Depth of one pass that stays above the part</source>
        <translation>Profondità di una passata che resta sopra il pezzo</translation>
    </message>
    <message>
        <source>Across the lines; more than the cutter&apos;s diameter</source>
        <translation>Di traverso alle linee; più del diametro della fresa</translation>
    </message>
    <message>
        <source>Along the lines, with the ends that hold the block; more than the cutter&apos;s diameter</source>
        <translation>Lungo le linee, con le estremità che tengono il blocco; più del diametro della fresa</translation>
    </message>
    <message>
        <source>Thickness that is milled away over the whole part</source>
        <translation>Spessore asportato su tutto il pezzo</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Distanza di sicurezza</translation>
    </message>
    <message>
        <source>Height of rapid moves above the block</source>
        <translation>Altezza dei movimenti rapidi sopra il blocco</translation>
    </message>
    <message>
        <source>Of the contour, at the part&apos;s lower end along y; cut by hand</source>
        <translation>Del contorno, all&apos;estremità inferiore del pezzo lungo y; si taglia a mano</translation>
    </message>
    <message>
        <source>Stepover</source>
        <translation>Passo laterale</translation>
    </message>
    <message>
        <source>Stock beyond the part, y</source>
        <translation>Sovrametallo oltre il pezzo, y</translation>
    </message>
    <message>
        <source>Stock beyond the part, x</source>
        <translation>Sovrametallo oltre il pezzo, x</translation>
    </message>
    <message>
        <source>Stock above and below</source>
        <translation>Sovrametallo sopra e sotto</translation>
    </message>
    <message>
        <source>Holding tab</source>
        <translation>Linguetta di tenuta</translation>
    </message>
</context>
<context>
    <name>MillPicture</name>
    <message>
        <source>Block</source>
        <translation>Blocco</translation>
    </message>
    <message>
        <source>Rapid moves</source>
        <translation>Movimenti rapidi</translation>
    </message>
    <message>
        <source>Side A, roughing</source>
        <translation>Lato A, sgrossatura</translation>
    </message>
    <message>
        <source>Side A, finishing</source>
        <translation>Lato A, finitura</translation>
    </message>
    <message>
        <source>Side B, roughing</source>
        <translation>Lato B, sgrossatura</translation>
    </message>
    <message>
        <source>Side B, finishing</source>
        <translation>Lato B, finitura</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contorno</translation>
    </message>
</context>
<context>
    <name>ModeSwitch</name>
    <message>
        <source>This way of building does not support that platform.</source>
        <translation>Questo modo di costruire non ammette quella piattaforma.</translation>
    </message>
    <message>
        <source>This way of building places the part itself: the search for an orientation does not apply.</source>
        <translation>Questo modo di costruire posa da sé il pezzo: la ricerca di un orientamento non si applica.</translation>
    </message>
    <message>
        <source>This way of building needs the scale as a number.</source>
        <translation>Questo modo di costruire vuole la scala come numero.</translation>
    </message>
    <message>
        <source>The platform file %1 is missing.</source>
        <translation>Manca il file della piattaforma, %1.</translation>
    </message>
    <message>
        <source>This way of building needs a cell with a rotating rod.</source>
        <translation>Questo modo di costruire vuole una cella con una barra rotante.</translation>
    </message>
    <message>
        <source>This cell rotates a rod: this way of building needs one with a plate.</source>
        <translation>Questa cella fa girare una barra: questo modo di costruire ne vuole una con un piatto.</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>on</source>
        <translation>sì</translation>
    </message>
    <message>
        <source>off</source>
        <translation>no</translation>
    </message>
    <message>
        <source>Range: %1 to %2</source>
        <translation>Intervallo: da %1 a %2</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Predefinito: %1</translation>
    </message>
    <message>
        <source>Key: %1</source>
        <translation>Chiave: %1</translation>
    </message>
</context>
<context>
    <name>PresetBar</name>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salva</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Salva &amp;come…</translation>
    </message>
    <message>
        <source>D&amp;iscard changes</source>
        <translation>Sc&amp;arta modifiche</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Rinomina…</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>&amp;Elimina…</translation>
    </message>
    <message>
        <source>&amp;Compare with…</source>
        <translation>C&amp;onfronta con…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>Es&amp;porta…</translation>
    </message>
    <message>
        <source>I&amp;mport…</source>
        <translation>I&amp;mporta…</translation>
    </message>
</context>
<context>
    <name>Quote</name>
    <message>
        <source>Quote: %1</source>
        <translation>Preventivo: %1</translation>
    </message>
    <message>
        <source>Price: %1</source>
        <translation>Prezzo: %1</translation>
    </message>
    <message>
        <source>printed in %1, %2 g of material</source>
        <translation>stampato in %1, %2 g di materiale</translation>
    </message>
    <message>
        <source>The price of a material is missing.</source>
        <translation>Manca il prezzo di un materiale.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensioni</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>%1, %2 g at %3 per kg: %4</source>
        <translation>%1, %2 g a %3 al kg: %4</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>%1 at %2 per hour: %3</source>
        <translation>%1 a %2 all&apos;ora: %3</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Preparazione</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margine</translation>
    </message>
    <message>
        <source>Price</source>
        <translation>Prezzo</translation>
    </message>
</context>
<context>
    <name>Resume</name>
    <message>
        <source>Bead %1 of %2</source>
        <translation>Cordone %1 di %2</translation>
    </message>
</context>
<context>
    <name>SettingWords</name>
    <message>
        <source>quality, resolution, thickness, fine, coarse, detail</source>
        <translation>qualità, risoluzione, spessore, fine, grezzo, dettaglio</translation>
    </message>
    <message>
        <source>line width, extrusion width, nozzle, bead</source>
        <translation>larghezza della linea, larghezza di estrusione, ugello, cordone</translation>
    </message>
    <message>
        <source>first layer, adhesion, line width, extrusion width</source>
        <translation>primo strato, adesione, larghezza della linea, larghezza di estrusione</translation>
    </message>
    <message>
        <source>retract, ooze, stringing, oozing</source>
        <translation>ritiro, colatura, fili, gocciolamento</translation>
    </message>
    <message>
        <source>resolution, point distance, segment length</source>
        <translation>risoluzione, distanza dei punti, lunghezza dei segmenti</translation>
    </message>
    <message>
        <source>perimeter, perimeters, shell, shells, outline, contour, strength</source>
        <translation>perimetro, perimetri, guscio, gusci, contorno, bordo, resistenza</translation>
    </message>
    <message>
        <source>fill, pattern, solid, interior</source>
        <translation>riempimento, motivo, pieno, interno</translation>
    </message>
    <message>
        <source>fill, percent, solid, hollow, strength, interior</source>
        <translation>riempimento, percento, pieno, cavo, resistenza, interno</translation>
    </message>
    <message>
        <source>fill, infill, gyroid, honeycomb, grid</source>
        <translation>riempimento, infill, gyroid, nido d&apos;ape, griglia</translation>
    </message>
    <message>
        <source>roof, skin, top surface, shell</source>
        <translation>tetto, pelle, superficie superiore, guscio</translation>
    </message>
    <message>
        <source>floor, skin, bottom surface, shell</source>
        <translation>fondo, pelle, superficie inferiore, guscio</translation>
    </message>
    <message>
        <source>roof, floor, top, bottom, shell</source>
        <translation>tetto, fondo, sopra, sotto, guscio</translation>
    </message>
    <message>
        <source>orientation, rotation</source>
        <translation>orientamento, rotazione</translation>
    </message>
    <message>
        <source>overhang, support, support material, bridge, hanging</source>
        <translation>sbalzo, supporto, materiale di supporto, ponte, sospeso</translation>
    </message>
    <message>
        <source>overhang, support material, hanging, edge</source>
        <translation>sbalzo, materiale di supporto, sospeso, bordo</translation>
    </message>
    <message>
        <source>support, bridge, hanging, tilt</source>
        <translation>supporto, ponte, sospeso, inclinazione</translation>
    </message>
    <message>
        <source>skirt, purge, priming, start line, prime line</source>
        <translation>gonna, spurgo, innesco, linea iniziale, linea di innesco</translation>
    </message>
    <message>
        <source>skirt, purge, start line</source>
        <translation>gonna, spurgo, linea iniziale</translation>
    </message>
    <message>
        <source>adhesion, skirt, raft, warping, lifting, bed</source>
        <translation>adesione, gonna, zattera, deformazione, distacco, piano</translation>
    </message>
    <message>
        <source>zipper, start point, z seam, scar</source>
        <translation>cucitura, punto iniziale, cucitura z, segno</translation>
    </message>
    <message>
        <source>thin, narrow, detail</source>
        <translation>sottile, stretto, dettaglio</translation>
    </message>
    <message>
        <source>vase, spiralize, continuous</source>
        <translation>vaso, spirale, continuo</translation>
    </message>
    <message>
        <source>vase</source>
        <translation>vaso</translation>
    </message>
    <message>
        <source>cooling, fan, temperature, overheating</source>
        <translation>raffreddamento, ventola, temperatura, surriscaldamento</translation>
    </message>
    <message>
        <source>cooling, temperature, fan, pause, wait, overheating</source>
        <translation>raffreddamento, temperatura, ventola, pausa, attesa, surriscaldamento</translation>
    </message>
    <message>
        <source>temperature, adhesion, cold joint, interlayer</source>
        <translation>temperatura, adesione, giunto freddo, tra gli strati</translation>
    </message>
    <message>
        <source>strength, force, stress</source>
        <translation>resistenza, forza, tensione</translation>
    </message>
    <message>
        <source>perimeter, feed rate, velocity</source>
        <translation>perimetro, avanzamento, velocità</translation>
    </message>
    <message>
        <source>fill, feed rate, velocity</source>
        <translation>riempimento, avanzamento, velocità</translation>
    </message>
    <message>
        <source>overhang, feed rate, velocity</source>
        <translation>sbalzo, avanzamento, velocità</translation>
    </message>
    <message>
        <source>adhesion, feed rate, velocity, bed</source>
        <translation>adesione, avanzamento, velocità, piano</translation>
    </message>
    <message>
        <source>z hop, travel, retract, hop</source>
        <translation>salto z, spostamento, ritiro, salto</translation>
    </message>
    <message>
        <source>stringing, ooze, seam</source>
        <translation>fili, colatura, cucitura</translation>
    </message>
    <message>
        <source>tool orientation, spin</source>
        <translation>orientamento dell&apos;utensile, rotazione</translation>
    </message>
    <message>
        <source>tool orientation, angle</source>
        <translation>orientamento dell&apos;utensile, angolo</translation>
    </message>
    <message>
        <source>collision, distance, safety, robot</source>
        <translation>collisione, distanza, sicurezza, robot</translation>
    </message>
    <message>
        <source>collision, distance, safety, nozzle</source>
        <translation>collisione, distanza, sicurezza, ugello</translation>
    </message>
    <message>
        <source>collision, check</source>
        <translation>collisione, controllo</translation>
    </message>
    <message>
        <source>configuration, flip, elbow, wrist</source>
        <translation>configurazione, inversione, gomito, polso</translation>
    </message>
    <message>
        <source>acceleration, vibration, smooth</source>
        <translation>accelerazione, vibrazione, dolce</translation>
    </message>
    <message>
        <source>rotate, orientation, auto orient, lay flat</source>
        <translation>ruota, orientamento, orientamento automatico, appoggia</translation>
    </message>
    <message>
        <source>repair, hole, mesh, thin, shell</source>
        <translation>riparazione, foro, mesh, sottile, guscio</translation>
    </message>
    <message>
        <source>variable layer height, quality</source>
        <translation>altezza variabile degli strati, qualità</translation>
    </message>
    <message>
        <source>variable layer height, quality, adaptive</source>
        <translation>altezza variabile degli strati, qualità, adattivo</translation>
    </message>
    <message>
        <source>extruder, nozzle, multi material, head</source>
        <translation>estrusore, ugello, più materiali, testa</translation>
    </message>
    <message>
        <source>extruder, multi material, soluble</source>
        <translation>estrusore, più materiali, solubile</translation>
    </message>
    <message>
        <source>extruder, multi material, fill</source>
        <translation>estrusore, più materiali, riempimento</translation>
    </message>
    <message>
        <source>extruder, multi material</source>
        <translation>estrusore, più materiali</translation>
    </message>
    <message>
        <source>tool change, wipe tower, multi material, colour change</source>
        <translation>cambio utensile, torre di pulizia, più materiali, cambio colore</translation>
    </message>
    <message>
        <source>carbon, continuous fibre, reinforcement, strength</source>
        <translation>carbonio, fibra continua, rinforzo, resistenza</translation>
    </message>
    <message>
        <source>resolution, grid</source>
        <translation>risoluzione, griglia</translation>
    </message>
    <message>
        <source>split program, memory</source>
        <translation>dividere il programma, memoria</translation>
    </message>
    <message>
        <source>simplify, tolerance</source>
        <translation>semplificare, tolleranza</translation>
    </message>
    <message>
        <source>G2, G3, circle</source>
        <translation>G2, G3, cerchio</translation>
    </message>
    <message>
        <source>tolerance, strict, draft</source>
        <translation>tolleranza, severo, bozza</translation>
    </message>
    <message>
        <source>strategy, slicing, non-planar, way of building</source>
        <translation>strategia, taglio in strati, non planare, modo di costruire</translation>
    </message>
    <message>
        <source>plate, bed, build plate, table, rod</source>
        <translation>piano, letto, piano di stampa, tavola, barra</translation>
    </message>
    <message>
        <source>robot, arm, machine, printer, nozzle, head</source>
        <translation>robot, braccio, macchina, stampante, ugello, testa</translation>
    </message>
    <message>
        <source>nozzle, tool, extruder, speed, feed rate, bead, head, temperature</source>
        <translation>ugello, utensile, estrusore, velocità, avanzamento, cordone, testa, temperatura</translation>
    </message>
    <message>
        <source>temperature, filament, plastic, heat, hot end, bed, fan, cooling, price, cost, flow, retraction</source>
        <translation>temperatura, filamento, plastica, calore, hot end, piano, ventola, raffreddamento, prezzo, costo, flusso, ritiro</translation>
    </message>
    <message>
        <source>tool, second nozzle, extruder, multi material, tool change, colour</source>
        <translation>utensile, secondo ugello, estrusore, più materiali, cambio utensile, colore</translation>
    </message>
    <message>
        <source>scheme, curved, algorithm</source>
        <translation>schema, curvo, algoritmo</translation>
    </message>
    <message>
        <source>random, repeatable</source>
        <translation>casuale, ripetibile</translation>
    </message>
    <message>
        <source>as process</source>
        <translation>come il processo</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <source>no brim</source>
        <translation>nessuna tesa</translation>
    </message>
    <message>
        <source>as the part</source>
        <translation>come il pezzo</translation>
    </message>
    <message>
        <source>no tapes</source>
        <translation>nessun nastro</translation>
    </message>
    <message>
        <source>all that fit</source>
        <translation>quanti ci stanno</translation>
    </message>
    <message>
        <source>only waits</source>
        <translation>solo attese</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>nessun limite</translation>
    </message>
    <message>
        <source>one bead</source>
        <translation>un cordone</translation>
    </message>
    <message>
        <source>never</source>
        <translation>mai</translation>
    </message>
    <message>
        <source>as format</source>
        <translation>come il formato</translation>
    </message>
    <message>
        <source>round</source>
        <translation>rotondo</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatico</translation>
    </message>
    <message>
        <source>pause, stop, colour change, insert, M600</source>
        <translation>pausa, stop, cambio colore, inserto, M600</translation>
    </message>
</context>
<context>
    <name>SizesDialog</name>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Slot length</source>
        <translation>Lunghezza della fessura</translation>
    </message>
    <message>
        <source>Slot width</source>
        <translation>Larghezza della fessura</translation>
    </message>
    <message>
        <source>Hole diameter</source>
        <translation>Diametro del foro</translation>
    </message>
</context>
<context>
    <name>TypedChange</name>
    <message>
        <source>%1: %2 mm</source>
        <translation>%1: %2 mm</translation>
    </message>
</context>
<context>
    <name>ValueBoxes</name>
    <message>
        <source>%1 to %2</source>
        <translation>da %1 a %2</translation>
    </message>
    <message>
        <source>This character is not possible here. Enter a number: %1.</source>
        <translation>Questo carattere non è possibile qui. Inserisci un numero: %1.</translation>
    </message>
    <message>
        <source>%1 is not possible here: %2 is used. Range: %3.</source>
        <translation>%1 non è possibile qui: si usa %2. Intervallo: %3.</translation>
    </message>
</context>
<context>
    <name>voluta::document::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Senza titolo</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>modifica di %1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>ripristino di %1</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>ripristino di tutti i parametri</translation>
    </message>
    <message>
        <source>Scale the part</source>
        <translation>scala del pezzo</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>apertura di %1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>aggiunta di %1</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>copia di %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>rimozione di %1</translation>
    </message>
    <message>
        <source>Change print order</source>
        <translation>modifica dell&apos;ordine di stampa</translation>
    </message>
    <message>
        <source>Arrange parts</source>
        <translation>Disponi i pezzi</translation>
    </message>
    <message>
        <source>Paste %1 parts</source>
        <translation>Incolla %1 pezzi</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Incolla %1</translation>
    </message>
    <message>
        <source>Remove %1 parts</source>
        <translation>Togli %1 pezzi</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Rinomina %1</translation>
    </message>
</context>
<context>
    <name>voluta::document::Opening</name>
    <message>
        <source>the rest of %1</source>
        <translation>il resto di %1</translation>
    </message>
</context>
<context>
    <name>voluta::document::RecentFiles</name>
    <message>
        <source>%1 no longer exists. It was removed from the list.</source>
        <translation>%1 non esiste più. È stato tolto dall&apos;elenco.</translation>
    </message>
</context>
<context>
    <name>voluta::document::Saving</name>
    <message>
        <source>There is nothing to save yet. Open a part first.</source>
        <translation>Non c&apos;è ancora niente da salvare. Apri prima un pezzo.</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ChoicesForm</name>
    <message>
        <source>Mode</source>
        <translation>Modalità</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Piattaforma</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cella</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Processo</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Seme</translation>
    </message>
    <message>
        <source>Another seed may find other travel paths; the same seed always gives the same result.</source>
        <translation>Un altro seme può trovare altri tragitti a vuoto; lo stesso seme dà sempre lo stesso risultato.</translation>
    </message>
    <message>
        <source>Your own cells are JSON files in %1</source>
        <translation>Le proprie celle sono file JSON in %1</translation>
    </message>
    <message>
        <source>Your own processes are JSON files in %1</source>
        <translation>I propri processi sono file JSON in %1</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>Your own materials are JSON files in %1</source>
        <translation>I tuoi materiali sono file JSON in %1</translation>
    </message>
    <message>
        <source>Edit processes</source>
        <translation>Modifica i processi</translation>
    </message>
    <message>
        <source>Edit materials</source>
        <translation>Modifica i materiali</translation>
    </message>
    <message>
        <source>Growth scheme</source>
        <translation>Schema di crescita</translation>
    </message>
    <message>
        <source>How the part is divided into layers</source>
        <translation>Come il pezzo è diviso in strati</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ParameterForm</name>
    <message>
        <source>Simple</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Show the most important and the changed parameters</source>
        <translation>Mostra i parametri più importanti e quelli modificati</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tutti</translation>
    </message>
    <message>
        <source>Show every parameter</source>
        <translation>Mostra tutti i parametri</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Ripristina</translation>
    </message>
    <message>
        <source>Reset every parameter to its default</source>
        <translation>Riporta ogni parametro al valore predefinito</translation>
    </message>
    <message>
        <source>No matching parameter.</source>
        <translation>Nessun parametro corrispondente.</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Stampa</translation>
    </message>
    <message>
        <source>Research</source>
        <translation>Ricerca</translation>
    </message>
    <message>
        <source>Search settings</source>
        <translation>Cerca impostazioni</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ParameterRow</name>
    <message>
        <source>Reset to %1</source>
        <translation>Ripristina %1</translation>
    </message>
    <message>
        <source>Files (%1)</source>
        <translation>File (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tutti i file (*)</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Scegli un file</translation>
    </message>
</context>
<context>
    <name>voluta::forms::PlatformEditor</name>
    <message>
        <source>Body to print on</source>
        <translation>Corpo su cui stampare</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Scegli un file…</translation>
    </message>
    <message>
        <source>A closed mesh, positioned as in the part&apos;s file</source>
        <translation>Una mesh chiusa, posizionata come nel file del pezzo</translation>
    </message>
    <message>
        <source>%1
Click to choose another one</source>
        <translation>%1
Fai clic per sceglierne un altro</translation>
    </message>
    <message>
        <source>Stepped: x,radius points</source>
        <translation>A gradini: punti x,raggio</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Tonda</translation>
    </message>
    <message>
        <source>Hexagonal, across corners</source>
        <translation>Esagonale, sugli spigoli</translation>
    </message>
    <message>
        <source>%1 sides, across corners</source>
        <translation>%1 lati, sugli spigoli</translation>
    </message>
    <message>
        <source>Shape of the rod</source>
        <translation>Forma della barra</translation>
    </message>
    <message>
        <source>Profile of the rod</source>
        <translation>Profilo della barra</translation>
    </message>
    <message>
        <source>Pairs of x and radius in mm; a step has two pairs at one x</source>
        <translation>Coppie di x e raggio in mm; un gradino ha due coppie alla stessa x</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Mesh (%1);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Surface on which the print begins</source>
        <translation>Superficie su cui la stampa comincia</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ToolRows</name>
    <message>
        <source>Add tool</source>
        <translation>Aggiungi utensile</translation>
    </message>
    <message>
        <source>Adds a second nozzle or material, for some parts, supports, pieces or the interior. The program stops for each change.</source>
        <translation>Aggiunge un secondo ugello o materiale, per alcuni pezzi, i supporti, le parti o l&apos;interno. Il programma si ferma a ogni cambio.</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Utensile %1</translation>
    </message>
    <message>
        <source>Process of tool %1</source>
        <translation>Processo dell&apos;utensile %1</translation>
    </message>
    <message>
        <source>Material of tool %1</source>
        <translation>Materiale dell&apos;utensile %1</translation>
    </message>
    <message>
        <source>Remove tool %1</source>
        <translation>Togli l&apos;utensile %1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ComparePanel</name>
    <message>
        <source>Cells</source>
        <translation>Celle</translation>
    </message>
    <message>
        <source>Compares these cells; none selected: the job&apos;s own</source>
        <translation>Confronta queste celle; nessuna scelta: quella del lavoro</translation>
    </message>
    <message>
        <source>Open a part first.</source>
        <translation>Apri prima un pezzo.</translation>
    </message>
    <message>
        <source>Select what to compare.</source>
        <translation>Seleziona che cosa confrontare.</translation>
    </message>
    <message>
        <source>Plans: %1</source>
        <translation>Piani: %1</translation>
    </message>
    <message>
        <source>Ways of building</source>
        <translation>Modi di costruire</translation>
    </message>
    <message>
        <source>Growth of curved layers</source>
        <translation>Crescita degli strati curvi</translation>
    </message>
    <message>
        <source>Platforms</source>
        <translation>Piattaforme</translation>
    </message>
    <message>
        <source>Delete removes the selected one from the list</source>
        <translation>Canc rimuove dall&apos;elenco quella selezionata</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Aggiungi</translation>
    </message>
    <message>
        <source>Also compare with this platform</source>
        <translation>Confronta anche con questa piattaforma</translation>
    </message>
    <message>
        <source>Plan up to</source>
        <translation>Pianifica fino a</translation>
    </message>
    <message>
        <source>verified programs</source>
        <translation>programmi verificati</translation>
    </message>
    <message>
        <source>missed voxels and pieces</source>
        <translation>voxel persi e pezzi</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Confronta</translation>
    </message>
    <message>
        <source>Plans them one after the other, in the background</source>
        <translation>Li pianifica uno dopo l&apos;altro, in secondo piano</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Stops; completed rows are kept</source>
        <translation>Ferma; le righe completate restano</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesi</translation>
    </message>
    <message>
        <source>Ways without blocking findings rank first, then the lowest score: each figure as a share of the column&apos;s largest, times its weight.</source>
        <translation>Prima i modi senza segnalazioni bloccanti, poi il punteggio minore: ogni valore come quota del massimo della colonna, per il suo peso.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Ripristina</translation>
    </message>
    <message>
        <source>Restore the default weights</source>
        <translation>Ripristina i pesi predefiniti</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CompareTable</name>
    <message>
        <source>Best</source>
        <translation>Migliore</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>In uso</translation>
    </message>
    <message>
        <source>Rank, and the score below it: lower is better</source>
        <translation>Posizione e, sotto, il punteggio: meno è meglio</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Posto</translation>
    </message>
    <message>
        <source>Way of building</source>
        <translation>Modo di costruire</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CursorInfo</name>
    <message>
        <source>Line %1</source>
        <translation>Riga %1</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Riga</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Ugello</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Inclinazione</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocità</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Giunti</translation>
    </message>
    <message>
        <source>The nozzle&apos;s tip, from the middle of the platform</source>
        <translation>La punta dell&apos;ugello, dal centro della piattaforma</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>Printed</source>
        <translation>Stampato</translation>
    </message>
    <message>
        <source>About X, Y and Z of the platform, from the upright nozzle</source>
        <translation>Attorno a X, Y e Z della piattaforma, dall&apos;ugello verticale</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CutPanel</name>
    <message>
        <source>Cut</source>
        <translation>Taglia</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Taglia %1</translation>
    </message>
    <message>
        <source>Perpendicular to</source>
        <translation>Perpendicolare a</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>Distance from the lowest point of the part along the axis</source>
        <translation>Distanza dal punto più basso del pezzo lungo l&apos;asse</translation>
    </message>
    <message>
        <source>Tilt about %1</source>
        <translation>Inclinazione attorno a %1</translation>
    </message>
    <message>
        <source>Parallel to a face</source>
        <translation>Parallelo a una faccia</translation>
    </message>
    <message>
        <source>Then click the face; the plane goes through the clicked point</source>
        <translation>Poi clicca la faccia; il piano passa per il punto cliccato</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conserva</translation>
    </message>
    <message>
        <source>Both halves</source>
        <translation>Entrambe le metà</translation>
    </message>
    <message>
        <source>Lower half</source>
        <translation>Metà inferiore</translation>
    </message>
    <message>
        <source>Upper half</source>
        <translation>Metà superiore</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Incastro</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nessuno</translation>
    </message>
    <message>
        <source>Dowels</source>
        <translation>Spine</translation>
    </message>
    <message>
        <source>Pegs</source>
        <translation>Perni</translation>
    </message>
    <message>
        <source>Dovetail</source>
        <translation>Coda di rondine</translation>
    </message>
    <message>
        <source>Dowels: loose pins in holes of both halves. Pegs: pins of the lower half. Dovetail: a tongue of the lower half in a groove.</source>
        <translation>Spine: perni sciolti in fori di entrambe le metà. Perni: della metà inferiore. Coda di rondine: una linguetta della metà inferiore in una scanalatura.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diametro</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altezza</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondità</translation>
    </message>
    <message>
        <source>Height of the tongue</source>
        <translation>Altezza della linguetta</translation>
    </message>
    <message>
        <source>Of a pin in each half</source>
        <translation>Di un perno in ogni metà</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Gioco</translation>
    </message>
    <message>
        <source>Gap on every side of a pin or of the tongue</source>
        <translation>Gioco su ogni lato di un perno o della linguetta</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numero</translation>
    </message>
    <message>
        <source>Pins in each section, if there is room</source>
        <translation>Perni in ogni sezione, se c&apos;è spazio</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direzione</translation>
    </message>
    <message>
        <source>In which the dovetail slides, from the horizontal</source>
        <translation>In cui scorre la coda di rondine, dall&apos;orizzontale</translation>
    </message>
    <message>
        <source>Lay halves on their cut face</source>
        <translation>Appoggia le metà sulla faccia tagliata</translation>
    </message>
    <message>
        <source>A half with pegs or a tongue keeps its orientation</source>
        <translation>Una metà con perni o linguetta mantiene l&apos;orientamento</translation>
    </message>
    <message>
        <source>Show apart</source>
        <translation>Mostra separate</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
</context>
<context>
    <name>voluta::panels::EffectCard</name>
    <message>
        <source>Undo</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Takes the remedy back, and shows the plan before it</source>
        <translation>Annulla il rimedio e mostra il piano precedente</translation>
    </message>
    <message>
        <source>Hide this</source>
        <translation>Nascondi</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ExportPanel</name>
    <message>
        <source>Replay of %1</source>
        <translation>Verifica di %1</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Verifica</translation>
    </message>
    <message>
        <source>Choose at least one format.</source>
        <translation>Scegli almeno un formato.</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>Scegli una cartella.</translation>
    </message>
    <message>
        <source>Folder for the programs</source>
        <translation>Cartella dei programmi</translation>
    </message>
    <message>
        <source>Refused programs</source>
        <translation>Programmi respinti</translation>
    </message>
    <message>
        <source>The replay refused some of the programs. Never run them on a robot.</source>
        <translation>La verifica ha respinto alcuni programmi. Non eseguirli mai su un robot.</translation>
    </message>
    <message>
        <source>For inspection only, they can be saved as:</source>
        <translation>Solo per esaminarli, si possono salvare come:</translation>
    </message>
    <message>
        <source>Save them too</source>
        <translation>Salva anche questi</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Escludili</translation>
    </message>
    <message>
        <source>Formats</source>
        <translation>Formati</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Program text</source>
        <translation>Testo del programma</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Cartella</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Sfoglia…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Esporta</translation>
    </message>
    <message>
        <source>%1 options</source>
        <translation>Opzioni %1</translation>
    </message>
    <message>
        <source>Blocked plan</source>
        <translation>Piano bloccato</translation>
    </message>
    <message>
        <source>The plan has blocking findings: %1</source>
        <translation>Il piano ha segnalazioni bloccanti: %1</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Esporta comunque</translation>
    </message>
    <message>
        <source>Not as asked</source>
        <translation>Non come richiesto</translation>
    </message>
    <message>
        <source>Safe to run, not as asked: %1</source>
        <translation>Sicuro da eseguire, non come richiesto: %1</translation>
    </message>
    <message>
        <source>The part will differ from the requested one there. To export without this question, accept it in the list of findings.</source>
        <translation>Lì il pezzo sarà diverso da quello richiesto. Per esportare senza questa domanda, accettarlo nell&apos;elenco delle segnalazioni.</translation>
    </message>
    <message>
        <source>Do not run the programs before these are solved.</source>
        <translation>Non eseguire i programmi prima di aver risolto queste segnalazioni.</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Non controllato</translation>
    </message>
    <message>
        <source>Safe to run but for your own statements: %1</source>
        <translation>Sicuro da eseguire, salvo le istruzioni proprie: %1</translation>
    </message>
    <message>
        <source>Nothing checks what they do. Try them on the controller with the arm clear first.</source>
        <translation>Nulla controlla che cosa fanno. Provale prima sul controllore con il braccio in posizione libera.</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FindingsModel</name>
    <message>
        <source>Blocked: %1</source>
        <translation>Bloccante: %1</translation>
    </message>
    <message>
        <source>Worth knowing: %1</source>
        <translation>Avviso: %1</translation>
    </message>
    <message>
        <source>at %1, %2, %3 mm</source>
        <translation>a %1, %2, %3 mm</translation>
    </message>
    <message>
        <source>before the change</source>
        <translation>prima della modifica</translation>
    </message>
    <message>
        <source>Not as asked: %1</source>
        <translation>Non come richiesto: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n punto</numerusform>
            <numerusform>%n punti</numerusform>
        </translation>
    </message>
    <message>
        <source>Not checked: %1</source>
        <translation>Non controllato: %1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FindingsPanel</name>
    <message>
        <source>Findings</source>
        <translation>Segnalazioni</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>Segnalazioni (%1)</translation>
    </message>
    <message>
        <source>%1 blocking, %2 for information</source>
        <translation>%1 bloccanti, %2 informativi</translation>
    </message>
    <message>
        <source>Blocked (%1)</source>
        <translation>Bloccanti (%1)</translation>
    </message>
    <message>
        <source>No blocking findings.</source>
        <translation>Nessuna segnalazione bloccante.</translation>
    </message>
    <message>
        <source>No problems found.</source>
        <translation>Nessun problema trovato.</translation>
    </message>
    <message>
        <source>No findings yet.</source>
        <translation>Ancora nessuna segnalazione.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>Move the camera, the sliders and the robot there</source>
        <translation>Porta lì la vista, i cursori e il robot</translation>
    </message>
    <message>
        <source>Not checked: %1.</source>
        <translation>Non verificato: %1.</translation>
    </message>
    <message>
        <source>No problems found so far.</source>
        <translation>Finora nessun problema.</translation>
    </message>
    <message>
        <source>%1 blocking, %2 not as asked, %3 for information</source>
        <translation>%1 bloccanti, %2 non come richiesto, %3 informative</translation>
    </message>
    <message>
        <source>Not as asked (%1)</source>
        <translation>Non come richiesto (%1)</translation>
    </message>
    <message>
        <source>Blocked (%1), not as asked (%2)</source>
        <translation>Bloccato (%1), non come richiesto (%2)</translation>
    </message>
    <message>
        <source>Show only findings that block, or by which the part differs</source>
        <translation>Mostra solo le segnalazioni che bloccano o per cui il pezzo è diverso</translation>
    </message>
    <message>
        <source>What helps: %1</source>
        <translation>Che cosa aiuta: %1</translation>
    </message>
    <message>
        <source>Place %1 of %2</source>
        <translation>Punto %1 di %2</translation>
    </message>
    <message>
        <source>Show next</source>
        <translation>Mostra il prossimo</translation>
    </message>
    <message>
        <source>Apply and plan:</source>
        <translation>Applica e pianifica:</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FormatList</name>
    <message>
        <source>%1, foreign</source>
        <translation>%1, altra marca</translation>
    </message>
    <message>
        <source>For another maker&apos;s controller: where the nozzle goes, not how this robot moves</source>
        <translation>Per il controllore di un&apos;altra marca: dove va l&apos;ugello, non come si muove questo robot</translation>
    </message>
    <message>
        <source>Not replayed yet</source>
        <translation>Non ancora verificato</translation>
    </message>
    <message>
        <source>Passed: the replay found no errors</source>
        <translation>Superato: la verifica non ha trovato errori</translation>
    </message>
    <message>
        <source>Refused by the replay: %1</source>
        <translation>Respinto dalla verifica: %1</translation>
    </message>
    <message>
        <source>Not replayed since the change</source>
        <translation>Non verificato dopo la modifica</translation>
    </message>
    <message>
        <source>Not passed, the plan is blocked: %1</source>
        <translation>Non superato, il piano è bloccato: %1</translation>
    </message>
    <message>
        <source>Safe to run, not as asked: %1</source>
        <translation>Sicuro da eseguire, non come richiesto: %1</translation>
    </message>
    <message>
        <source>Safe to run but for your own statements: %1</source>
        <translation>Sicuro da eseguire, salvo le istruzioni proprie: %1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FrameForm</name>
    <message>
        <source>Place</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>About the fixed X, then Y, then Z axis</source>
        <translation>Attorno agli assi fissi X, poi Y, poi Z</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Lati</translation>
    </message>
    <message>
        <source>Place along %1</source>
        <translation>Posizione lungo %1</translation>
    </message>
    <message>
        <source>Turn about %1</source>
        <translation>Rotazione attorno a %1</translation>
    </message>
    <message>
        <source>Edge along %1</source>
        <translation>Spigolo lungo %1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::HeadDrawing</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Head, %1 × ⌀ %2 mm</source>
        <translation>Testina, %1 × ⌀ %2 mm</translation>
    </message>
    <message>
        <source>Bead, %1 × %2 mm</source>
        <translation>Cordone, %1 × %2 mm</translation>
    </message>
    <message>
        <source>Head, nozzle and bead, to scale</source>
        <translation>Testina, ugello e cordone, in scala</translation>
    </message>
    <message>
        <source>Left: profile of the head, used for collision checks. Right: its tip with a bead of the usual width and height.</source>
        <translation>A sinistra: profilo della testina, usato per le collisioni. A destra: la sua punta con un cordone di larghezza e altezza abituali.</translation>
    </message>
    <message>
        <source>The head&apos;s sections do not rise from the tip.</source>
        <translation>Le sezioni della testina non salgono dalla punta.</translation>
    </message>
</context>
<context>
    <name>voluta::panels::HeadTable</name>
    <message>
        <source>Height [mm]</source>
        <translation>Altezza [mm]</translation>
    </message>
    <message>
        <source>Radius [mm]</source>
        <translation>Raggio [mm]</translation>
    </message>
    <message>
        <source>Sections of the head from the tip up. Two rows of the same height are a step.</source>
        <translation>Sezioni della testina dalla punta in su. Due righe con la stessa altezza sono un gradino.</translation>
    </message>
    <message>
        <source>Sections of the head</source>
        <translation>Sezioni della testina</translation>
    </message>
    <message>
        <source>Add row</source>
        <translation>Aggiungi riga</translation>
    </message>
    <message>
        <source>Remove row</source>
        <translation>Togli riga</translation>
    </message>
    <message>
        <source>Reset head</source>
        <translation>Ripristina</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ItemForm</name>
    <message>
        <source>Choose a colour</source>
        <translation>Scegli un colore</translation>
    </message>
</context>
<context>
    <name>voluta::panels::JogPanel</name>
    <message>
        <source>Joints</source>
        <translation>Giunti</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Ugello</translation>
    </message>
    <message>
        <source>The tip on the platform, and rotations about X, Y and Z (A, B, C) from the upright nozzle</source>
        <translation>La punta sulla piattaforma, e le rotazioni attorno a X, Y e Z (A, B, C) dall&apos;ugello verticale</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>Step of X, Y and Z</source>
        <translation>Passo di X, Y e Z</translation>
    </message>
    <message>
        <source>Step of A, B and C</source>
        <translation>Passo di A, B e C</translation>
    </message>
    <message>
        <source>Back to the plan</source>
        <translation>Torna al piano</translation>
    </message>
    <message>
        <source>Joint %1</source>
        <translation>Giunto %1</translation>
    </message>
    <message>
        <source>%1 one step less</source>
        <translation>%1 un passo in meno</translation>
    </message>
    <message>
        <source>%1 one step more</source>
        <translation>%1 un passo in più</translation>
    </message>
</context>
<context>
    <name>voluta::panels::LayerInfo</name>
    <message>
        <source>Layer</source>
        <translation>Strato</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Porzioni</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Area</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Spessore</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Punti</translation>
    </message>
    <message>
        <source>Minimum, mean and maximum</source>
        <translation>Minimo, medio e massimo</translation>
    </message>
</context>
<context>
    <name>voluta::panels::MeshPanel</name>
    <message>
        <source>Repair the mesh</source>
        <translation>Ripara la mesh</translation>
    </message>
    <message>
        <source>Closes holes, orients triangles and removes duplicates, as far as the shape is not in doubt</source>
        <translation>Chiude i fori, orienta i triangoli e toglie i doppi, finché la forma non è in dubbio</translation>
    </message>
    <message>
        <source>No part is open.</source>
        <translation>Nessun pezzo aperto.</translation>
    </message>
    <message>
        <source>The mesh is not watertight.</source>
        <translation>La mesh non è chiusa.</translation>
    </message>
    <message>
        <source>The mesh is watertight.</source>
        <translation>La mesh è chiusa.</translation>
    </message>
    <message>
        <source>The mesh is watertight, but has defects.</source>
        <translation>La mesh è chiusa, ma ha difetti.</translation>
    </message>
    <message>
        <source>Triangles: %1</source>
        <translation>Triangoli: %1</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Trovato</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>Riparato</translation>
    </message>
    <message>
        <source>Remains</source>
        <translation>Resta</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ObjectTree</name>
    <message>
        <source>Part</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Piattaforma</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cella</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Ugello</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Piatto</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Nascondi</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>Part and cell</source>
        <translation>Pezzo e cella</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PaintForm</name>
    <message>
        <source>Paint with</source>
        <translation>Dipingi con</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pennello</translation>
    </message>
    <message>
        <source>Whole faces</source>
        <translation>Facce intere</translation>
    </message>
    <message>
        <source>Up to edges of</source>
        <translation>Fino a spigoli di</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Raggio</translation>
    </message>
    <message>
        <source>Paint on the part. Shift or the right button erases.</source>
        <translation>Dipingi sul pezzo. Maiusc o il tasto destro cancella.</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rettangolo</translation>
    </message>
    <message>
        <source>Drag a rectangle: it paints what you see in it. Shift or the right button erases.</source>
        <translation>Trascina un rettangolo: dipinge ciò che vi si vede. Maiusc o il tasto destro cancella.</translation>
    </message>
    <message>
        <source>Layers while the brush rests</source>
        <translation>Strati mentre il pennello è fermo</translation>
    </message>
    <message>
        <source>One second after a stroke, the layers are made again in the background</source>
        <translation>Un secondo dopo una pennellata, gli strati vengono rifatti in secondo piano</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PartList</name>
    <message>
        <source>Part</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modalità</translation>
    </message>
    <message>
        <source>Size [mm]</source>
        <translation>Misure [mm]</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Aggiungi…</translation>
    </message>
    <message>
        <source>Adds a part from a file beside the others</source>
        <translation>Aggiunge un pezzo da un file accanto agli altri</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplica</translation>
    </message>
    <message>
        <source>Adds a copy of the selected part with its settings</source>
        <translation>Aggiunge una copia del pezzo scelto con le sue impostazioni</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>Removes the selected part; can be undone</source>
        <translation>Toglie il pezzo scelto; si può annullare</translation>
    </message>
    <message>
        <source>Print order</source>
        <translation>Ordine di stampa</translation>
    </message>
    <message>
        <source>One after another</source>
        <translation>Uno dopo l&apos;altro</translation>
    </message>
    <message>
        <source>Layer by layer</source>
        <translation>Strato per strato</translation>
    </message>
    <message>
        <source>One after another: each part is finished before the next begins. Layer by layer: all parts grow together.</source>
        <translation>Uno dopo l&apos;altro: ogni pezzo è finito prima che cominci il successivo. Strato per strato: tutti i pezzi crescono insieme.</translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation>Disponi</translation>
    </message>
    <message>
        <source>Moves all parts beside each other, with room for the print head</source>
        <translation>Mette tutti i pezzi uno accanto all&apos;altro, con spazio per la testa di stampa</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PiecesPanel</name>
    <message>
        <source>Printed as number %1, on piece %2</source>
        <translation>Stampato come numero %1, sul pezzo %2</translation>
    </message>
    <message>
        <source>Printed as number %1, on the plate</source>
        <translation>Stampato come numero %1, sul piatto</translation>
    </message>
    <message>
        <source>Needs support: %1, uncut %2</source>
        <translation>Richiede supporto: %1, senza tagli %2</translation>
    </message>
    <message>
        <source>With this cut: %1 need support. Press Plan.</source>
        <translation>Con questo taglio: %1 da supportare. Premi Pianifica.</translation>
    </message>
    <message>
        <source>With this cut: about %1 need support</source>
        <translation>Con questo taglio: circa %1 da supportare</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Risky</source>
        <translation>A rischio</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>In print order; each piece is listed below the one it is printed on</source>
        <translation>In ordine di stampa; ogni pezzo sta sotto quello su cui è stampato</translation>
    </message>
    <message>
        <source>Area that needs support when the piece is printed from its base</source>
        <translation>Area che richiede supporto quando il pezzo è stampato a partire dalla sua base</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>Moves each piece away from the one it is printed on</source>
        <translation>Allontana ogni pezzo da quello su cui è stampato</translation>
    </message>
    <message>
        <source>Base planes</source>
        <translation>Piani di base</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Cerca di nuovo</translation>
    </message>
    <message>
        <source>Keep these cuts</source>
        <translation>Tieni questi tagli</translation>
    </message>
    <message>
        <source>Discards your cuts and searches for others</source>
        <translation>Scarta i tuoi tagli e ne cerca altri</translation>
    </message>
    <message>
        <source>Keeps these cuts: they become your own and are not searched again</source>
        <translation>Conserva questi tagli: diventano tuoi e non vengono più cercati</translation>
    </message>
    <message>
        <source>Pick root</source>
        <translation>Scegli la radice</translation>
    </message>
    <message>
        <source>Then click a point on the piece to print first</source>
        <translation>Poi fare clic su un punto del pezzo da stampare per primo</translation>
    </message>
    <message>
        <source>Click a piece to see its base plane and to move that cut.</source>
        <translation>Fai clic su un pezzo per vedere il suo piano di base e spostare quel taglio.</translation>
    </message>
    <message>
        <source>Drag the arrow to move the cut, a ring to tilt it. Esc deselects.</source>
        <translation>Trascina la freccia per spostare il taglio, un anello per inclinarlo. Esc deseleziona.</translation>
    </message>
    <message>
        <source>This piece is on the plate: it has no cut to move.</source>
        <translation>Questo pezzo è sul piatto: non ha un taglio da spostare.</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Numeri</translation>
    </message>
    <message>
        <source>In the picture, in print order</source>
        <translation>Nell&apos;immagine, in ordine di stampa</translation>
    </message>
    <message>
        <source>Shows where each piece is cut</source>
        <translation>Mostra dove ogni pezzo è tagliato</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PlacementPanel</name>
    <message>
        <source>Drop to plate</source>
        <translation>Abbassa sul piatto</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centra</translation>
    </message>
    <message>
        <source>Reset placement</source>
        <translation>Ripristina posizione</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Sposta</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Ruota</translation>
    </message>
    <message>
        <source>About the fixed axes: first X, then Y, then Z</source>
        <translation>Attorno agli assi fissi: prima X, poi Y, poi Z</translation>
    </message>
    <message>
        <source>Height of the lowest point above the plate</source>
        <translation>Altezza del punto più basso sopra il piatto</translation>
    </message>
    <message>
        <source>Centre of the part along %1</source>
        <translation>Centro del pezzo lungo %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Sposta %1</translation>
    </message>
    <message>
        <source>Rotate about the fixed axis %1; X comes first, then Y, then Z</source>
        <translation>Ruota attorno all&apos;asse fisso %1; prima X, poi Y, poi Z</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>Ruota %1</translation>
    </message>
    <message>
        <source>Rotate by -90° about %1, from the present orientation</source>
        <translation>Ruota di -90° attorno a %1, dall&apos;orientamento attuale</translation>
    </message>
    <message>
        <source>Rotate by 90° about %1, from the present orientation</source>
        <translation>Ruota di 90° attorno a %1, dall&apos;orientamento attuale</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Scala</translation>
    </message>
    <message>
        <source>Scale in percent</source>
        <translation>Scala in percento</translation>
    </message>
    <message>
        <source>Scale as a factor</source>
        <translation>Fattore di scala</translation>
    </message>
    <message>
        <source>Fit to reach</source>
        <translation>Adatta al braccio</translation>
    </message>
    <message>
        <source>Scale down, if necessary, to the size that the arm reaches everywhere</source>
        <translation>Riduce, se serve, fino a ciò che il braccio raggiunge ovunque</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Misure</translation>
    </message>
    <message>
        <source>Lay on face</source>
        <translation>Appoggia su faccia</translation>
    </message>
    <message>
        <source>Then click the face to place on the plate</source>
        <translation>Poi fai clic sulla faccia da appoggiare sul piatto</translation>
    </message>
    <message>
        <source>Put the centre of the part over the centre of the plate</source>
        <translation>Porta il centro del pezzo sul centro del piatto</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Ripristina</translation>
    </message>
    <message>
        <source>Position and size as in the file</source>
        <translation>Posizione e misure come nel file</translation>
    </message>
    <message>
        <source>Size along %1. A new size scales the part as a whole.</source>
        <translation>Dimensione lungo %1. Una nuova dimensione scala tutto il pezzo.</translation>
    </message>
    <message>
        <source>Size along %1</source>
        <translation>Dimensione lungo %1</translation>
    </message>
    <message>
        <source>Millimetres or inches</source>
        <translation>Millimetri o pollici</translation>
    </message>
    <message>
        <source>Unit of the size</source>
        <translation>Unità della dimensione</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ProgramFacts</name>
    <message>
        <source>Assumptions about the controller</source>
        <translation>Ipotesi sul controllore</translation>
    </message>
    <message>
        <source>%1 in one file</source>
        <translation>%1 in un file</translation>
    </message>
    <message>
        <source>%1 in %2 files</source>
        <translation>%1 in %2 file</translation>
    </message>
    <message>
        <source>Time on the controller: %1, as planned</source>
        <translation>Tempo sul controllore: %1, come previsto</translation>
    </message>
    <message>
        <source>Time on the controller: %1, %3 % more than the planned time of %2</source>
        <translation>Tempo sul controllore: %1, il %3 % in più del tempo previsto di %2</translation>
    </message>
    <message>
        <source>Time on the controller: %1, %3 % less than the planned time of %2</source>
        <translation>Tempo sul controllore: %1, il %3 % in meno del tempo previsto di %2</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ReachPanel</name>
    <message>
        <source>Calculating…</source>
        <translation>Calcolo in corso…</translation>
    </message>
    <message>
        <source>No part on a plate.</source>
        <translation>Nessun pezzo su un piatto.</translation>
    </message>
    <message>
        <source>The part is off the plate.</source>
        <translation>Il pezzo è fuori dal piatto.</translation>
    </message>
    <message>
        <source>Fully reachable upright.</source>
        <translation>Tutto raggiungibile in verticale.</translation>
    </message>
    <message>
        <source>%1 % reachable upright.</source>
        <translation>Raggiungibile in verticale: %1 %.</translation>
    </message>
    <message>
        <source>With up to %1° of tilt: %2 %.</source>
        <translation>Con inclinazione fino a %1°: %2 %.</translation>
    </message>
    <message>
        <source>There %1 % is reachable upright, %2 % tilted</source>
        <translation>Lì è raggiungibile il %1 % in verticale, il %2 % inclinato</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Portata</translation>
    </message>
    <message>
        <source>Reach of the head over the whole height of the part; collisions with printed material are not checked</source>
        <translation>Portata della testa su tutta l&apos;altezza del pezzo; le collisioni con il materiale stampato non sono verificate</translation>
    </message>
    <message>
        <source>Show on plate</source>
        <translation>Mostra sul piatto</translation>
    </message>
    <message>
        <source>Move to best place</source>
        <translation>Sposta al posto migliore</translation>
    </message>
</context>
<context>
    <name>voluta::panels::RegionsPanel</name>
    <message>
        <source>Regions</source>
        <translation>Regioni</translation>
    </message>
    <message>
        <source>Regions of %1</source>
        <translation>Regioni di %1</translation>
    </message>
    <message>
        <source>Rename region</source>
        <translation>Rinomina regione</translation>
    </message>
    <message>
        <source>Use of a region</source>
        <translation>Uso di una regione</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>Modifica regione</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Modifica %1</translation>
    </message>
    <message>
        <source>Delete region</source>
        <translation>Elimina regione</translation>
    </message>
    <message>
        <source>Order of regions</source>
        <translation>Ordine delle regioni</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Regione</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Uso</translation>
    </message>
    <message>
        <source>Where regions overlap, the lower one in the list holds. Double-click renames.</source>
        <translation>Dove le regioni si sovrappongono, vale quella più in basso nell&apos;elenco. Il doppio clic rinomina.</translation>
    </message>
    <message>
        <source>A region is printed by settings, or in layers, of its own.</source>
        <translation>Una regione è stampata con impostazioni, o in strati, propri.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Aggiungi</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Sposta su</translation>
    </message>
    <message>
        <source>Move down: where regions overlap, the lower one holds</source>
        <translation>Sposta giù: dove le regioni si sovrappongono, vale quella più in basso</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Sposta giù</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>Only a skin or a painted surface says which faces the layers follow</source>
        <translation>Solo una pelle o una superficie dipinta dice quali facce seguono gli strati</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ResumeBar</name>
    <message>
        <source>Resume from here…</source>
        <translation>Riprendi da qui…</translation>
    </message>
    <message>
        <source>Opens the rest of a print that was stopped there as a new project</source>
        <translation>Apre il resto di una stampa interrotta lì come nuovo progetto</translation>
    </message>
</context>
<context>
    <name>voluta::panels::VerdictTable</name>
    <message>
        <source>Coverage</source>
        <translation>Copertura</translation>
    </message>
    <message>
        <source>Unsupported</source>
        <translation>Senza appoggio</translation>
    </message>
    <message>
        <source>Overfill</source>
        <translation>Eccesso</translation>
    </message>
    <message>
        <source>Mass error</source>
        <translation>Errore di massa</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Collisioni</translation>
    </message>
    <message>
        <source>Limit violations</source>
        <translation>Violazioni dei limiti</translation>
    </message>
    <message>
        <source>Path deviation</source>
        <translation>Scostamento dal percorso</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Within limit</source>
        <translation>Entro il limite</translation>
    </message>
    <message>
        <source>Outside limit</source>
        <translation>Fuori limite</translation>
    </message>
    <message>
        <source>Not checked since the change</source>
        <translation>Non verificato dopo la modifica</translation>
    </message>
    <message>
        <source>Less than half supported</source>
        <translation>Appoggio sotto la metà</translation>
    </message>
    <message>
        <source>Longest unsupported run</source>
        <translation>Tratto più lungo senza appoggio</translation>
    </message>
    <message>
        <source>Flow error</source>
        <translation>Errore di flusso</translation>
    </message>
    <message>
        <source>Time on the controller</source>
        <translation>Tempo sul controllore</translation>
    </message>
    <message>
        <source>Differences from the plan</source>
        <translation>Differenze dal piano</translation>
    </message>
    <message>
        <source>Outside limit, not refused</source>
        <translation>Fuori limite, non rifiutato</translation>
    </message>
    <message>
        <source>Thin and open</source>
        <translation>Sottile e aperto</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WayCard</name>
    <message>
        <source>Contact %1 mm²</source>
        <translation>Contatto %1 mm²</translation>
    </message>
    <message>
        <source>Missed voxels %1</source>
        <translation>Voxel mancati %1</translation>
    </message>
    <message>
        <source>About %1</source>
        <translation>Circa %1</translation>
    </message>
    <message>
        <source>contact %1 mm², overhang %2 mm²
%3 mm high
%4 of %5 voxels missed in one growth pass
about %6, estimated from size, walls and infill without supports</source>
        <translation>contatto %1 mm², sbalzo %2 mm²
altezza %3 mm
%4 voxel mancati su %5 in una passata di crescita
circa %6, stimato da misure, pareti e riempimento senza supporti</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WaysList</name>
    <message>
        <source>Calculating…</source>
        <translation>Calcolo in corso…</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>nessuno trovato</translation>
    </message>
    <message>
        <source>custom orientation</source>
        <translation>orientamento personalizzato</translation>
    </message>
    <message>
        <source>Orientations</source>
        <translation>Orientamenti</translation>
    </message>
    <message>
        <source>Click one to orient the part that way</source>
        <translation>Fai clic su uno per orientare così il pezzo</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WrittenBar</name>
    <message>
        <source>Open report</source>
        <translation>Apri il rapporto</translation>
    </message>
    <message>
        <source>The report to hand over: verdict, margins and hashes of the program</source>
        <translation>Il rapporto da consegnare: esito, margini e impronte del programma</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>Mostra la cartella</translation>
    </message>
    <message>
        <source>Opens the folder with the programs in the file manager</source>
        <translation>Apre la cartella con i programmi nel gestore dei file</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::JointPlots</name>
    <message>
        <source>Angle (°)</source>
        <translation>Angolo (°)</translation>
    </message>
    <message>
        <source>Speed (°/s)</source>
        <translation>Velocità (°/s)</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Tempo (s)</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angolo</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocità</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Entrambi</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limiti</translation>
    </message>
    <message>
        <source>Show the limits of the joints as dashed lines</source>
        <translation>Mostra i limiti dei giunti come linee tratteggiate</translation>
    </message>
    <message>
        <source>Show joint %1</source>
        <translation>Mostra il giunto %1</translation>
    </message>
    <message>
        <source>Preparing the curves…</source>
        <translation>Preparazione delle curve…</translation>
    </message>
    <message>
        <source>Joint curves appear here once the motion is planned.</source>
        <translation>Le curve dei giunti compaiono qui quando il movimento è pianificato.</translation>
    </message>
    <message>
        <source>No joint selected.</source>
        <translation>Nessun giunto scelto.</translation>
    </message>
    <message>
        <source>Show axis %1</source>
        <translation>Mostra l’asse %1</translation>
    </message>
    <message>
        <source>Angle (°), position (mm)</source>
        <translation>Angolo (°), posizione (mm)</translation>
    </message>
    <message>
        <source>Speed (°/s, mm/s)</source>
        <translation>Velocità (°/s, mm/s)</translation>
    </message>
    <message>
        <source>Jerk (rad/s³)</source>
        <translation>Strappo (rad/s³)</translation>
    </message>
    <message>
        <source>Jerk (rad/s³, mm/s³)</source>
        <translation>Strappo (rad/s³, mm/s³)</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Strappo</translation>
    </message>
    <message>
        <source>Earlier motion</source>
        <translation>Moto precedente</translation>
    </message>
    <message>
        <source>Show the jerk of the motion planned before, in pale colours, to compare</source>
        <translation>Mostra lo strappo del moto pianificato prima, in colori tenui, per confrontare</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::LayerRangeSlider</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Shown layers</source>
        <translation>Strati mostrati</translation>
    </message>
    <message>
        <source>No layers</source>
        <translation>Nessuno strato</translation>
    </message>
    <message>
        <source>Layers %1 to %2 of %3</source>
        <translation>Strati da %1 a %2 di %3</translation>
    </message>
    <message>
        <source>Layers appear here once they are planned.</source>
        <translation>Gli strati compaiono qui quando sono pianificati.</translation>
    </message>
    <message>
        <source>Layers %1 to %2 of %3. Up and down keys move the upper end, with Shift the lower one; a double click shows a single layer.</source>
        <translation>Strati da %1 a %2 di %3. I tasti su e giù spostano l&apos;estremo superiore, con Maiusc quello inferiore; un doppio clic mostra un solo strato.</translation>
    </message>
    <message>
        <source>r %1 mm</source>
        <translation>r %1 mm</translation>
    </message>
    <message>
        <source>, a pause before the last</source>
        <translation>, una pausa prima dell&apos;ultimo</translation>
    </message>
    <message>
        <source>Remove the pause before layer %1</source>
        <translation>Rimuovi la pausa prima dello strato %1</translation>
    </message>
    <message>
        <source>Pause before layer %1: the arm goes beside the part and waits, for example to put in an insert</source>
        <translation>Pausa prima dello strato %1: il braccio va accanto al pezzo e attende, per esempio per inserire un elemento</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::TimelineBar</name>
    <message>
        <source>Wait: %1 s</source>
        <translation>Attesa: %1 s</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>movimento %1</translation>
    </message>
    <message>
        <source>Previous layer</source>
        <translation>Strato precedente</translation>
    </message>
    <message>
        <source>Previous move</source>
        <translation>Movimento precedente</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Avvia</translation>
    </message>
    <message>
        <source>Next move</source>
        <translation>Movimento successivo</translation>
    </message>
    <message>
        <source>Next layer</source>
        <translation>Strato successivo</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>Velocità di riproduzione</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Moves of the layer</source>
        <translation>Movimenti dello strato</translation>
    </message>
    <message>
        <source>growth step %1</source>
        <translation>passo di crescita %1</translation>
    </message>
    <message>
        <source>Ten steps back</source>
        <translation>Dieci passi indietro</translation>
    </message>
    <message>
        <source>Previous growth step</source>
        <translation>Passo di crescita precedente</translation>
    </message>
    <message>
        <source>Next growth step</source>
        <translation>Passo di crescita successivo</translation>
    </message>
    <message>
        <source>Ten steps forward</source>
        <translation>Dieci passi avanti</translation>
    </message>
    <message>
        <source>Growth steps</source>
        <translation>Passi di crescita</translation>
    </message>
    <message>
        <source>Printing time so far / planned time</source>
        <translation>Tempo di stampa trascorso / tempo previsto</translation>
    </message>
    <message>
        <source>Time-line</source>
        <translation>Linea del tempo</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::MachinesView</name>
    <message>
        <source>View of the machines</source>
        <translation>Vista delle macchine</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::ViewCube</name>
    <message>
        <source>Front</source>
        <translation>Fronte</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retro</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Sinistra</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Sopra</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Sotto</translation>
    </message>
    <message>
        <source>Click a face to look from there, drag to turn the view</source>
        <translation>Clic su una faccia per guardare da lì, trascina per ruotare la vista</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::Viewport</name>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
</context>
<context>
    <name>voluta::window::ArmImportDialog</name>
    <message>
        <source>Six axes with a spherical wrist, solved in closed form</source>
        <translation>Sei assi con polso sferico, risolti in forma chiusa</translation>
    </message>
    <message>
        <source>Six axes, 2 to 4 parallel, solved in closed form</source>
        <translation>Sei assi, da 2 a 4 paralleli, risolti in forma chiusa</translation>
    </message>
    <message>
        <source>Six axes with an offset wrist, solved by a search</source>
        <translation>Sei assi con polso piegato, risolti con una ricerca</translation>
    </message>
    <message>
        <source>Six axes, solved numerically: plans take longer</source>
        <translation>Sei assi, risolti numericamente: i piani durano di più</translation>
    </message>
    <message>
        <source>Import a robot arm</source>
        <translation>Importa un braccio robotico</translation>
    </message>
    <message>
        <source>Nozzle on the arm, plate on a table</source>
        <translation>Ugello sul braccio, piatto su un tavolo</translation>
    </message>
    <message>
        <source>Plate on the arm, nozzle fixed</source>
        <translation>Piatto sul braccio, ugello fisso</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>Flangia</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cella</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programmi</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importa</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Lettura…</translation>
    </message>
    <message>
        <source>Assumed:</source>
        <translation>Supposto:</translation>
    </message>
    <message>
        <source>An arm named %1 exists.</source>
        <translation>Esiste già un braccio di nome %1.</translation>
    </message>
    <message>
        <source>Replacing it loses the frames, obstacles and other changes in these files:</source>
        <translation>Sostituendolo si perdono i riferimenti, gli ostacoli e le altre modifiche in questi file:</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Sostituisci</translation>
    </message>
    <message>
        <source>Use another name</source>
        <translation>Usa un altro nome</translation>
    </message>
    <message>
        <source>Found in the file</source>
        <translation>Trovato nel file</translation>
    </message>
</context>
<context>
    <name>voluta::window::BodyTree</name>
    <message>
        <source>Robot&apos;s base</source>
        <translation>Base del robot</translation>
    </message>
    <message>
        <source>Flange of %1</source>
        <translation>Flangia di %1</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Ugello</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Piatto</translation>
    </message>
    <message>
        <source>in the flange</source>
        <translation>nella flangia</translation>
    </message>
    <message>
        <source>on the last axis</source>
        <translation>sull&apos;ultimo asse</translation>
    </message>
    <message>
        <source>on the previous axis</source>
        <translation>sull&apos;asse precedente</translation>
    </message>
    <message>
        <source>in the robot&apos;s base</source>
        <translation>nella base del robot</translation>
    </message>
    <message>
        <source>Place for purges</source>
        <translation>Punto di spurgo</translation>
    </message>
</context>
<context>
    <name>voluta::window::CellEditor</name>
    <message>
        <source>in the flange</source>
        <translation>nella flangia</translation>
    </message>
    <message>
        <source>Edit cell</source>
        <translation>Modifica cella</translation>
    </message>
    <message>
        <source>Save as my cell</source>
        <translation>Salva come mia cella</translation>
    </message>
    <message>
        <source>Mass on the flange before printing: the plate and its stem, or head and extruder</source>
        <translation>Massa sulla flangia prima della stampa: il piatto col suo stelo, o testa ed estrusore</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Extruder</source>
        <translation>Estrusore</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Carico</translation>
    </message>
    <message>
        <source>Add box</source>
        <translation>Aggiungi scatola</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Togli</translation>
    </message>
    <message>
        <source>Find home pose</source>
        <translation>Trova posizione di riposo</translation>
    </message>
    <message>
        <source>Finds the home pose with the greatest clearance, the nozzle over the plate</source>
        <translation>Trova la posizione di riposo con la massima distanza da tutto, l&apos;ugello sopra il piatto</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ripeti</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>extruder</source>
        <translation>estrusore</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>carico</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>sposta %1</translation>
    </message>
    <message>
        <source>edges of %1</source>
        <translation>lati di %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Select a body to move it</source>
        <translation>Seleziona un corpo per spostarlo</translation>
    </message>
    <message>
        <source>checking…</source>
        <translation>controllo in corso…</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Nessun problema.</translation>
    </message>
    <message>
        <source>add a box</source>
        <translation>aggiungi una scatola</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>togli %1</translation>
    </message>
    <message>
        <source>home pose</source>
        <translation>posizione di riposo</translation>
    </message>
    <message>
        <source>No collision-free home pose over the plate was found.</source>
        <translation>Nessuna posizione di riposo senza collisioni trovata sopra il piatto.</translation>
    </message>
    <message>
        <source>Replace the cell %1?</source>
        <translation>Sostituire la cella %1?</translation>
    </message>
    <message>
        <source>Add from file…</source>
        <translation>Aggiungi da file…</translation>
    </message>
    <message>
        <source>An obstacle from a drawing: a mesh, approximated by boxes, cylinders and capsules</source>
        <translation>Un ostacolo da un disegno: una mesh, approssimata da parallelepipedi, cilindri e capsule</translation>
    </message>
    <message>
        <source>Measure…</source>
        <translation>Misura…</translation>
    </message>
    <message>
        <source>Computes the body&apos;s pose from points touched at the real cell</source>
        <translation>Calcola la posa del corpo da punti toccati nella cella reale</translation>
    </message>
    <message>
        <source>Collision solids</source>
        <translation>Solidi di collisione</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Lettura di %1…</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>aggiungi %1</translation>
    </message>
    <message>
        <source>in the robot&apos;s base, axes at 0</source>
        <translation>nella base del robot, assi a 0</translation>
    </message>
    <message>
        <source>measure %1</source>
        <translation>misura %1</translation>
    </message>
    <message>
        <source>Shows the solids used for collision checks over the arm</source>
        <translation>Mostra sopra il braccio i solidi controllati per le collisioni</translation>
    </message>
    <message>
        <source>searching…</source>
        <translation>ricerca in corso…</translation>
    </message>
    <message>
        <source>Discard the changes to this cell?</source>
        <translation>Scartare le modifiche a questa cella?</translation>
    </message>
    <message>
        <source>The last one is: %1.</source>
        <translation>L&apos;ultima è: %1.</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Scarta</translation>
    </message>
    <message>
        <source>Add place for purges</source>
        <translation>Aggiungi punto di spurgo</translation>
    </message>
    <message>
        <source>Only a nozzle on the arm goes to a place for purges</source>
        <translation>Solo un ugello sul braccio va a un punto di spurgo</translation>
    </message>
    <message>
        <source>The cell has a place for purges: select it to move it</source>
        <translation>La cella ha un punto di spurgo: selezionalo per spostarlo</translation>
    </message>
    <message>
        <source>Where the nozzle&apos;s tip is when tools are changed and nozzles purged, instead of a place that the plan chooses</source>
        <translation>Dove si trova la punta dell&apos;ugello quando si cambiano utensili e si spurgano ugelli, al posto di un punto scelto dal piano</translation>
    </message>
    <message>
        <source>add the place for purges</source>
        <translation>aggiungi il punto di spurgo</translation>
    </message>
    <message>
        <source>Bodies of the cell</source>
        <translation>Corpi della cella</translation>
    </message>
</context>
<context>
    <name>voluta::window::ChoicesEditor</name>
    <message>
        <source>growth</source>
        <translation>crescita</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>piattaforma</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>cella</translation>
    </message>
    <message>
        <source>process</source>
        <translation>processo</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>seme</translation>
    </message>
    <message>
        <source>cell %1</source>
        <translation>cella %1</translation>
    </message>
    <message>
        <source>platform %1</source>
        <translation>piattaforma %1</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>processo %1</translation>
    </message>
    <message>
        <source>scale %1</source>
        <translation>scala %1</translation>
    </message>
    <message>
        <source>the part&apos;s orientation unchanged</source>
        <translation>l&apos;orientamento del pezzo invariato</translation>
    </message>
    <message>
        <source>rod shape</source>
        <translation>forma della barra</translation>
    </message>
    <message>
        <source>way of building</source>
        <translation>modo di costruire</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>Scegli il file…</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Usa %1</translation>
    </message>
    <message>
        <source>Which body is printed on? If none is chosen, the plate.</source>
        <translation>Su quale corpo si stampa? Senza, è il piatto.</translation>
    </message>
    <message>
        <source>Choose the body…</source>
        <translation>Scegli il corpo…</translation>
    </message>
    <message>
        <source>Changed with it: %1.</source>
        <translation>Cambiati insieme: %1.</translation>
    </message>
    <message>
        <source>choices that fit the way of building</source>
        <translation>scelte adatte al modo di costruire</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatico</translation>
    </message>
    <message>
        <source>The first way of building and platform without blocking findings.</source>
        <translation>Il primo modo di costruire e la prima piattaforma senza segnalazioni bloccanti.</translation>
    </message>
    <message>
        <source>Rejected: %1.</source>
        <translation>Scartato: %1.</translation>
    </message>
    <message>
        <source>material</source>
        <translation>materiale</translation>
    </message>
    <message>
        <source>%1 g/cm³</source>
        <translation>%1 g/cm³</translation>
    </message>
    <message>
        <source>nozzle %1 °C</source>
        <translation>ugello %1 °C</translation>
    </message>
    <message>
        <source>plate %1 °C</source>
        <translation>piatto %1 °C</translation>
    </message>
    <message>
        <source>fan %1 %</source>
        <translation>ventola %1 %</translation>
    </message>
    <message>
        <source>up to %1 mm³/s</source>
        <translation>fino a %1 mm³/s</translation>
    </message>
    <message>
        <source>tool added</source>
        <translation>utensile aggiunto</translation>
    </message>
    <message>
        <source>tool removed</source>
        <translation>utensile tolto</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1/kg</source>
        <translation>%1/kg</translation>
    </message>
</context>
<context>
    <name>voluta::window::CommandPalette</name>
    <message>
        <source>Commands and settings</source>
        <translation>Comandi e impostazioni</translation>
    </message>
    <message>
        <source>Find a command or a setting</source>
        <translation>Trova un comando o un&apos;impostazione</translation>
    </message>
    <message>
        <source>No command and no setting has these words.</source>
        <translation>Nessun comando e nessuna impostazione ha queste parole.</translation>
    </message>
</context>
<context>
    <name>voluta::window::CompareItemsDialog</name>
    <message>
        <source>Compare</source>
        <translation>Confronta</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Campo</translation>
    </message>
    <message>
        <source>No differences.</source>
        <translation>Nessuna differenza.</translation>
    </message>
    <message>
        <source>Differing fields: %1</source>
        <translation>Campi diversi: %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::ComparePage</name>
    <message>
        <source>Nothing can be compared</source>
        <translation>Non c&apos;è nulla da confrontare</translation>
    </message>
    <message>
        <source>Adopted: %1. Press Plan.</source>
        <translation>Adottato: %1. Premi Pianifica.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ComparePresetsDialog</name>
    <message>
        <source>Compare presets</source>
        <translation>Confronta preset</translation>
    </message>
    <message>
        <source>First preset</source>
        <translation>Primo preset</translation>
    </message>
    <message>
        <source>Second preset</source>
        <translation>Secondo preset</translation>
    </message>
    <message>
        <source>Settings that differ</source>
        <translation>Impostazioni che differiscono</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Impostazione</translation>
    </message>
    <message>
        <source>No differences.</source>
        <translation>Nessuna differenza.</translation>
    </message>
    <message>
        <source>Settings that differ: %1</source>
        <translation>Impostazioni che differiscono: %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::CompareView</name>
    <message>
        <source>way of building</source>
        <translation>modo di costruire</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>In corso</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>In attesa</translation>
    </message>
    <message>
        <source>Not planned</source>
        <translation>Non pianificato</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Superato</translation>
    </message>
    <message>
        <source>No blocking findings</source>
        <translation>Nessuna segnalazione bloccante</translation>
    </message>
    <message>
        <source>Blocked: %1</source>
        <translation>Bloccato: %1</translation>
    </message>
    <message>
        <source>Cannot be planned</source>
        <translation>Non pianificabile</translation>
    </message>
    <message>
        <source>Planned in %1</source>
        <translation>Pianificato in %1</translation>
    </message>
    <message>
        <source>Out of date: the part or its settings have changed since.</source>
        <translation>Superato: il pezzo o le impostazioni sono cambiati.</translation>
    </message>
    <message>
        <source>Best: %1.</source>
        <translation>Migliore: %1.</translation>
    </message>
    <message>
        <source>As good: %1.</source>
        <translation>Altrettanto buoni: %1.</translation>
    </message>
    <message>
        <source>None is best: all of them are blocked.</source>
        <translation>Nessuno è il migliore: sono tutti bloccati.</translation>
    </message>
    <message>
        <source>Which way of building suits this part?
Tick the ways to compare at the right, then press Compare.</source>
        <translation>Quale modo di costruire conviene a questo pezzo?
Spunta a destra i modi da confrontare, poi premi Confronta.</translation>
    </message>
    <message>
        <source>Adopt this way</source>
        <translation>Adotta questo modo</translation>
    </message>
    <message>
        <source>Builds the part as in the selected row; can be undone</source>
        <translation>Costruisce il pezzo come la riga selezionata; si può annullare</translation>
    </message>
</context>
<context>
    <name>voluta::window::CopiesDialog</name>
    <message>
        <source>Number of copies</source>
        <translation>Numero di copie</translation>
    </message>
    <message>
        <source>Number of these parts on the plate; all parts are arranged anew</source>
        <translation>Numero di questi pezzi sul piatto; tutti i pezzi sono disposti di nuovo</translation>
    </message>
    <message>
        <source>&amp;Copies on the plate</source>
        <translation>&amp;Copie sul piatto</translation>
    </message>
    <message>
        <source>&amp;Fill the plate</source>
        <translation>&amp;Riempi il piatto</translation>
    </message>
    <message>
        <source>As many copies as the plate has room for</source>
        <translation>Quante copie il piatto può contenere</translation>
    </message>
</context>
<context>
    <name>voluta::window::CutTool</name>
    <message>
        <source>Calculating…</source>
        <translation>Calcolo…</translation>
    </message>
    <message>
        <source>Lower half %1 cm³, upper half %2 cm³.</source>
        <translation>Metà inferiore %1 cm³, metà superiore %2 cm³.</translation>
    </message>
    <message>
        <source>Pins: %1.</source>
        <translation>Perni: %1.</translation>
    </message>
    <message>
        <source>Cutting…</source>
        <translation>Taglio…</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Taglia</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Taglia %1</translation>
    </message>
    <message>
        <source>dowel</source>
        <translation>spina</translation>
    </message>
    <message>
        <source>Split to parts</source>
        <translation>Separa in pezzi</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>Separa %1</translation>
    </message>
    <message>
        <source>The mesh has more than %1 bodies.</source>
        <translation>La mesh ha più di %1 corpi.</translation>
    </message>
    <message>
        <source>The part is one body.</source>
        <translation>Il pezzo è un solo corpo.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n pezzo</numerusform>
            <numerusform>%n pezzi</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. Their regions have moved with them.</source>
        <translation>%1. Le loro regioni si sono spostate insieme.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ExportPage</name>
    <message>
        <source>Open a part first.</source>
        <translation>Apri prima un pezzo.</translation>
    </message>
    <message>
        <source>Planning is in progress.</source>
        <translation>Pianificazione in corso.</translation>
    </message>
    <message>
        <source>Nothing has been planned yet. Press Plan.</source>
        <translation>Ancora niente di pianificato. Premi Pianifica.</translation>
    </message>
    <message>
        <source>Programs are not saved in a project. Press Plan to generate them.</source>
        <translation>I programmi non si salvano nel progetto. Premi Pianifica per generarli.</translation>
    </message>
    <message>
        <source>The programs are out of date. Press Plan.</source>
        <translation>I programmi non sono aggiornati. Premi Pianifica.</translation>
    </message>
    <message>
        <source>program formats</source>
        <translation>formati dei programmi</translation>
    </message>
    <message>
        <source>Files written to %1: %2</source>
        <translation>File scritti in %1: %2</translation>
    </message>
    <message>
        <source>; refused and not written: %1</source>
        <translation>; respinti e non scritti: %1</translation>
    </message>
    <message>
        <source>; the reports have no pictures: %1</source>
        <translation>; le prove non hanno immagini: %1</translation>
    </message>
    <message>
        <source>The files are being written.</source>
        <translation>I file sono in scrittura.</translation>
    </message>
    <message>
        <source>Nothing was exported</source>
        <translation>Niente è stato esportato</translation>
    </message>
    <message>
        <source>The replay refused all programs: %1.</source>
        <translation>La verifica ha rifiutato tutti i programmi: %1.</translation>
    </message>
    <message>
        <source>Replace files?</source>
        <translation>Sostituire i file?</translation>
    </message>
    <message>
        <source>These files already exist in %1:</source>
        <translation>Questi file esistono già in %1:</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Sostituisci</translation>
    </message>
    <message>
        <source>This is the rest of a print made with other settings. Undo the change: Plan would plan the whole part again.</source>
        <translation>Questo è il resto di una stampa fatta con altre impostazioni. Annulla la modifica: Pianifica rifarebbe tutto il pezzo.</translation>
    </message>
    <message>
        <source>Slower on the controller by %1 s</source>
        <translation>Più lento sul controllore: %1 s in più</translation>
    </message>
    <message>
        <source>Line %1, %2</source>
        <translation>Riga %1, %2</translation>
    </message>
    <message>
        <source>Verify a program</source>
        <translation>Verifica un programma</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tutti i file (*)</translation>
    </message>
    <message>
        <source>Cannot open %1</source>
        <translation>Impossibile aprire %1</translation>
    </message>
    <message>
        <source>No program on this computer is set up to open it.</source>
        <translation>Su questo computer nessun programma è impostato per aprirlo.</translation>
    </message>
</context>
<context>
    <name>voluta::window::FilmDialog</name>
    <message>
        <source>Film</source>
        <translation>Filmato</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Length of the film. The whole print is shown in it, with equal steps</source>
        <translation>Durata del filmato. Mostra tutta la stampa, a passi uguali</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrica</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Davanti</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Sopra</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Durata</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>Di&amp;mensioni</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vista</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Salva…</translation>
    </message>
    <message>
        <source>Save the film</source>
        <translation>Salva il filmato</translation>
    </message>
    <message>
        <source>Films (*.webm)</source>
        <translation>Filmati (*.webm)</translation>
    </message>
</context>
<context>
    <name>voluta::window::FlowBar</name>
    <message>
        <source>nothing yet</source>
        <translation>ancora niente</translation>
    </message>
    <message>
        <source>running</source>
        <translation>in corso</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fatto</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>non aggiornato</translation>
    </message>
    <message>
        <source>blocked: see the findings</source>
        <translation>bloccato: vedi le segnalazioni</translation>
    </message>
    <message>
        <source>not as asked or not checked: see the findings</source>
        <translation>non come richiesto o non controllato: vedere le segnalazioni</translation>
    </message>
</context>
<context>
    <name>voluta::window::HeadNumbersDialog</name>
    <message>
        <source>Head from a few numbers</source>
        <translation>Testina da pochi numeri</translation>
    </message>
    <message>
        <source>The head contains the corners of the square block.</source>
        <translation>La testina contiene gli spigoli del blocco quadrato.</translation>
    </message>
    <message>
        <source>Use this head</source>
        <translation>Usa questa testina</translation>
    </message>
</context>
<context>
    <name>voluta::window::Jogging</name>
    <message>
        <source>Collision: %1 and %2</source>
        <translation>Collisione: %1 e %2</translation>
    </message>
    <message>
        <source>Free: more than %1 mm between bodies</source>
        <translation>Libero: più di %1 mm tra i corpi</translation>
    </message>
    <message>
        <source>Free: %1 mm between the nearest bodies</source>
        <translation>Libero: %1 mm tra i corpi più vicini</translation>
    </message>
    <message>
        <source>The arm does not reach that pose within its joint limits. It stays here.</source>
        <translation>Il braccio non raggiunge quella posa entro i limiti dei giunti. Resta qui.</translation>
    </message>
    <message>
        <source>The printed part is not checked yet.</source>
        <translation>Il pezzo stampato non è ancora controllato.</translation>
    </message>
    <message>
        <source>Checking the pose…</source>
        <translation>Controllo della posa…</translation>
    </message>
</context>
<context>
    <name>voluta::window::JoinedMachines</name>
    <message>
        <source>Machine %1</source>
        <translation>Macchina %1</translation>
    </message>
    <message>
        <source>Waits %1 for machine %2</source>
        <translation>Attende %1 la macchina %2</translation>
    </message>
</context>
<context>
    <name>voluta::window::LayerEventDialog</name>
    <message>
        <source>Event before layer %1</source>
        <translation>Evento prima dello strato %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Attesa</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Uscita</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Utensile</translation>
    </message>
    <message>
        <source>Own statement</source>
        <translation>Istruzione propria</translation>
    </message>
    <message>
        <source>Shown to the operator; the arm waits until the operator continues</source>
        <translation>Mostrato all&apos;operatore; il braccio attende finché l&apos;operatore non prosegue</translation>
    </message>
    <message>
        <source>This line is written into programs of the format. Nothing checks it</source>
        <translation>Questa riga viene scritta nei programmi del formato. Nulla la controlla</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Accesa</translation>
    </message>
    <message>
        <source>&amp;Event</source>
        <translation>&amp;Evento</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>Te&amp;sto</translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation>&amp;Durata</translation>
    </message>
    <message>
        <source>&amp;Number</source>
        <translation>&amp;Numero</translation>
    </message>
    <message>
        <source>&amp;Tool</source>
        <translation>&amp;Utensile</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Formato</translation>
    </message>
    <message>
        <source>&amp;Line</source>
        <translation>&amp;Riga</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>The camera&apos;s output is on for this long; the arm waits beside the part</source>
        <translation>L&apos;uscita della fotocamera resta accesa per questo tempo; il braccio attende accanto al pezzo</translation>
    </message>
    <message>
        <source>Change of filament</source>
        <translation>Cambio del filamento</translation>
    </message>
</context>
<context>
    <name>voluta::window::LayersPage</name>
    <message>
        <source>Replaying growth: all layers shown</source>
        <translation>Si rivede la crescita: tutti gli strati</translation>
    </message>
    <message>
        <source>Pieces are always shown whole</source>
        <translation>I pezzi sono mostrati interi</translation>
    </message>
    <message>
        <source>Event before this layer…</source>
        <translation>Evento prima di questo strato…</translation>
    </message>
    <message>
        <source>A pause, a wait, an output, another tool or a line of your own</source>
        <translation>Una pausa, un&apos;attesa, un&apos;uscita, un altro utensile o una riga propria</translation>
    </message>
</context>
<context>
    <name>voluta::window::LegendView</name>
    <message>
        <source>Click to show these beads</source>
        <translation>Fai clic per mostrare questi cordoni</translation>
    </message>
    <message>
        <source>Click to hide these beads</source>
        <translation>Fai clic per nascondere questi cordoni</translation>
    </message>
</context>
<context>
    <name>voluta::window::LibraryDialog</name>
    <message>
        <source>Processes and materials</source>
        <translation>Processi e materiali</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salva</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Annulla modifiche</translation>
    </message>
    <message>
        <source>Use in this job</source>
        <translation>Usa in questo lavoro</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Confronta…</translation>
    </message>
    <message>
        <source>Processes</source>
        <translation>Processi</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materiali</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplica</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Rinomina…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Elimina…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Esporta…</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importa…</translation>
    </message>
    <message>
        <source>From a few numbers…</source>
        <translation>Da pochi numeri…</translation>
    </message>
    <message>
        <source>From a mesh…</source>
        <translation>Da una mesh…</translation>
    </message>
    <message>
        <source>A drawing of the head with its nozzle pointing down: the largest radius at each height</source>
        <translation>Un disegno della testina con l&apos;ugello verso il basso: il raggio maggiore a ogni altezza</translation>
    </message>
    <message>
        <source>%1 (in this job)</source>
        <translation>%1 (in questo lavoro)</translation>
    </message>
    <message>
        <source>Comes with the program</source>
        <translation>Fornito con il programma</translation>
    </message>
    <message>
        <source>Stored in this job</source>
        <translation>Contenuto in questo lavoro</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Proprio</translation>
    </message>
    <message>
        <source>Comes with the program. Duplicate it to change it.</source>
        <translation>Fornito con il programma. Duplicalo per modificarlo.</translation>
    </message>
    <message>
        <source>Stored in this job, not in your library. Duplicate it to keep it.</source>
        <translation>Contenuto in questo lavoro, non nella libreria. Duplicalo per conservarlo.</translation>
    </message>
    <message>
        <source>Your own.</source>
        <translation>Proprio.</translation>
    </message>
    <message>
        <source>Your own, based on %1; fields that differ are marked.</source>
        <translation>Proprio, basato su %1; i campi diversi sono segnati.</translation>
    </message>
    <message>
        <source>Cannot be saved: %1 %2</source>
        <translation>Non si può salvare: %1 %2</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Testina</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>Non ancora salvato.</translation>
    </message>
    <message>
        <source>Save and use in this job</source>
        <translation>Salva e usa in questo lavoro</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Rinomina</translation>
    </message>
    <message>
        <source>Small letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;:</source>
        <translation>Lettere minuscole, cifre, «-», «_» e «.»:</translation>
    </message>
    <message>
        <source>There is another &apos;%1&apos;.</source>
        <translation>C&apos;è già un altro «%1».</translation>
    </message>
    <message>
        <source>Delete %1 and its file?</source>
        <translation>Eliminare %1 e il suo file?</translation>
    </message>
    <message>
        <source>Import a process</source>
        <translation>Importa un processo</translation>
    </message>
    <message>
        <source>Import a material</source>
        <translation>Importa un materiale</translation>
    </message>
    <message>
        <source>JSON files (*.json);;All files (*)</source>
        <translation>File JSON (*.json);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Replace your own %1?</source>
        <translation>Sostituire il proprio %1?</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>Esporta %1</translation>
    </message>
    <message>
        <source>JSON files (*.json)</source>
        <translation>File JSON (*.json)</translation>
    </message>
    <message>
        <source>Head from a mesh</source>
        <translation>Testina da una mesh</translation>
    </message>
    <message>
        <source>Save the changes?</source>
        <translation>Salvare le modifiche?</translation>
    </message>
    <message>
        <source>The job uses another version of this process.</source>
        <translation>Il lavoro usa un&apos;altra versione di questo processo.</translation>
    </message>
    <message>
        <source>Sizes from a measured plate…</source>
        <translation>Misure da una piastra rilevata…</translation>
    </message>
    <message>
        <source>Corrects the sizes of flat layers by those of a printed accuracy plate</source>
        <translation>Corregge le misure degli strati piani con quelle di una piastra stampata</translation>
    </message>
    <message>
        <source>Does the nozzle point up in the drawing?</source>
        <translation>Nel disegno l&apos;ugello punta verso l&apos;alto?</translation>
    </message>
    <message>
        <source>Turn it over</source>
        <translation>Capovolgila</translation>
    </message>
    <message>
        <source>Use it as drawn</source>
        <translation>Usala come disegnata</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Mesh (%1);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Your own. It follows %1 in all fields that are not marked.</source>
        <translation>Proprio. Segue %1 in tutti i campi non segnati.</translation>
    </message>
</context>
<context>
    <name>voluta::window::LogDialog</name>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 non si può leggere: %2.</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Apri la cartella</translation>
    </message>
    <message>
        <source>No program on this computer opens the folder %1.</source>
        <translation>Nessun programma su questo computer apre la cartella %1.</translation>
    </message>
</context>
<context>
    <name>voluta::window::MachineTable</name>
    <message>
        <source>Job</source>
        <translation>Lavoro</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cella</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>Macchine</translation>
    </message>
</context>
<context>
    <name>voluta::window::MainWindow</name>
    <message>
        <source>Part and cell</source>
        <translation>Pezzo e cella</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Segnalazioni</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Salva l&apos;immagine</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>Impossibile scrivere %1. Scegli un&apos;altra cartella.</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Barra</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 pezzi</translation>
    </message>
    <message>
        <source>Saved the film %1</source>
        <translation>Filmato %1 salvato</translation>
    </message>
</context>
<context>
    <name>voluta::window::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Manuale</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Cerca nel manuale</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Indice</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Pagina del manuale</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Indietro</translation>
    </message>
</context>
<context>
    <name>voluta::window::MeasureDialog</name>
    <message>
        <source>One point per row, in mm, %1. Three rows x, y, z: origin, a point on X, a point in the XY plane. Or at least three rows of six: nominal point, touched point.</source>
        <translation>Un punto per riga, in mm, %1. Tre righe x, y, z: origine, un punto su X, un punto nel piano XY. O almeno tre righe di sei: punto nominale, punto toccato.</translation>
    </message>
    <message>
        <source>At least four poses in which the tip touches the same point, tilted to different sides, one per row: the robot&apos;s joints, or x, y, z, qw, qx, qy, qz of the flange.</source>
        <translation>Almeno quattro pose in cui la punta tocca lo stesso punto, inclinata da parti diverse, una per riga: i giunti del robot, o x, y, z, qw, qx, qy, qz della flangia.</translation>
    </message>
    <message>
        <source>Measure %1</source>
        <translation>Misura %1</translation>
    </message>
    <message>
        <source>Use this frame</source>
        <translation>Usa questo riferimento</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Righe</translation>
    </message>
</context>
<context>
    <name>voluta::window::MeasureTool</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Round edge: radius %1, diameter %2</source>
        <translation>Spigolo rotondo: raggio %1, diametro %2</translation>
    </message>
    <message>
        <source>Round face: radius %1, diameter %2</source>
        <translation>Faccia rotonda: raggio %1, diametro %2</translation>
    </message>
    <message>
        <source>Ball: radius %1, diameter %2</source>
        <translation>Sfera: raggio %1, diametro %2</translation>
    </message>
    <message>
        <source>Corner: X %1, Y %2, Z %3</source>
        <translation>Vertice: X %1, Y %2, Z %3</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Spigolo</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Faccia</translation>
    </message>
    <message>
        <source>Wall behind the face: %1</source>
        <translation>Parete dietro la faccia: %1</translation>
    </message>
    <message>
        <source>Distance: %1</source>
        <translation>Distanza: %1</translation>
    </message>
    <message>
        <source>X %1, Y %2, Z %3</source>
        <translation>X %1, Y %2, Z %3</translation>
    </message>
    <message>
        <source>Distance of the parallel faces: %1</source>
        <translation>Distanza delle facce parallele: %1</translation>
    </message>
    <message>
        <source>Angle: %1°</source>
        <translation>Angolo: %1°</translation>
    </message>
    <message>
        <source>Click a corner, an edge or a face of the part.</source>
        <translation>Fai clic su un vertice, uno spigolo o una faccia del pezzo.</translation>
    </message>
    <message>
        <source>Click a second place for distance and angle.</source>
        <translation>Fai clic su un secondo punto per distanza e angolo.</translation>
    </message>
</context>
<context>
    <name>voluta::window::MillDialog</name>
    <message>
        <source>Mill %1 from a block</source>
        <translation>Fresa %1 da un blocco</translation>
    </message>
    <message>
        <source>Save G-code…</source>
        <translation>Salva il G-code…</translation>
    </message>
    <message>
        <source>Compute passes</source>
        <translation>Calcola le passate</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Milled block</source>
        <translation>Blocco fresato</translation>
    </message>
    <message>
        <source>Computing the passes and running them on the block…</source>
        <translation>Calcolo delle passate ed esecuzione sul blocco…</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annullato.</translation>
    </message>
    <message>
        <source>Values have changed: compute the passes again.</source>
        <translation>I valori sono cambiati: calcola di nuovo le passate.</translation>
    </message>
    <message>
        <source>Passed: the program was read back and run on the block.</source>
        <translation>Superato: il programma è stato riletto ed eseguito sul blocco.</translation>
    </message>
    <message>
        <source>Refused: %1 (%2)</source>
        <translation>Rifiutato: %1 (%2)</translation>
    </message>
    <message>
        <source>Block %1 × %2 × %3 mm</source>
        <translation>Blocco %1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Time %1, %2 moves</source>
        <translation>Tempo %1, %2 movimenti</translation>
    </message>
    <message>
        <source>Removed %1 of %2 cm³</source>
        <translation>Asportati %1 di %2 cm³</translation>
    </message>
    <message>
        <source>Left on the part: at most %1 mm</source>
        <translation>Rimasto sul pezzo: al massimo %1 mm</translation>
    </message>
    <message>
        <source>Missing from the part: at most %1 mm</source>
        <translation>Mancante dal pezzo: al massimo %1 mm</translation>
    </message>
    <message>
        <source>Save the G-code</source>
        <translation>Salva il G-code</translation>
    </message>
    <message>
        <source>G-code (*.nc)</source>
        <translation>G-code (*.nc)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Salvato %1</translation>
    </message>
    <message>
        <source>Not complete: %1 (%2)</source>
        <translation>Non completo: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>voluta::window::MillForm</name>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Denti</translation>
    </message>
    <message>
        <source>Lay the part down</source>
        <translation>Adagia il pezzo</translation>
    </message>
    <message>
        <source>Turns the part so that the least material is milled away; otherwise it keeps its orientation on the plate</source>
        <translation>Ruota il pezzo in modo da asportare meno materiale; altrimenti resta orientato come sul piano</translation>
    </message>
    <message>
        <source>%1 rpm, feed %2 mm/min, lines every %3 mm, fine passes of %4 mm</source>
        <translation>%1 giri/min, avanzamento %2 mm/min, linee ogni %3 mm, passate fini di %4 mm</translation>
    </message>
</context>
<context>
    <name>voluta::window::ObjectMenus</name>
    <message>
        <source>Show its place</source>
        <translation>Mostra il posto</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>Copia il testo</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Nascondi</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Mostra tutto</translation>
    </message>
    <message>
        <source>Show only this</source>
        <translation>Mostra solo questo</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Esporta…</translation>
    </message>
    <message>
        <source>Select this part</source>
        <translation>Scegli questo pezzo</translation>
    </message>
    <message>
        <source>Show all beads</source>
        <translation>Mostra tutti i cordoni</translation>
    </message>
    <message>
        <source>Show only layer %1</source>
        <translation>Mostra solo lo strato %1</translation>
    </message>
    <message>
        <source>Show up to layer %1</source>
        <translation>Mostra fino allo strato %1</translation>
    </message>
    <message>
        <source>Show all layers</source>
        <translation>Mostra tutti gli strati</translation>
    </message>
    <message>
        <source>Go to this moment</source>
        <translation>Vai a questo momento</translation>
    </message>
    <message>
        <source>Hide beads of this kind</source>
        <translation>Nascondi i cordoni di questo tipo</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Unità del file</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pollice</translation>
    </message>
    <message>
        <source>unit of the file</source>
        <translation>unità del file</translation>
    </message>
    <message>
        <source>Repair the mesh</source>
        <translation>Ripara la mesh</translation>
    </message>
    <message>
        <source>repair the mesh</source>
        <translation>ripara la mesh</translation>
    </message>
    <message>
        <source>mesh as read</source>
        <translation>mesh come letta</translation>
    </message>
</context>
<context>
    <name>voluta::window::ObstacleImport</name>
    <message>
        <source>Obstacle from a file</source>
        <translation>Ostacolo da file</translation>
    </message>
    <message>
        <source>%1 is %2 mm long. Was it drawn in metres?</source>
        <translation>%1 è lungo %2 mm. È stato disegnato in metri?</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Mesh (%1);;Tutti i file (*)</translation>
    </message>
</context>
<context>
    <name>voluta::window::PageStack</name>
    <message>
        <source>Preview</source>
        <translation>Anteprima</translation>
    </message>
    <message>
        <source>Layers, paths and programs are not up to date yet: press Plan.</source>
        <translation>Strati, percorsi e programmi non sono ancora aggiornati: premi Pianifica.</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Non aggiornato</translation>
    </message>
    <message>
        <source>The settings have changed since: press Plan.</source>
        <translation>Le impostazioni sono cambiate nel frattempo: premi Pianifica.</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Strato %1</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Totale</translation>
    </message>
</context>
<context>
    <name>voluta::window::PartHandles</name>
    <message>
        <source>drop to plate</source>
        <translation>abbassamento sul piatto</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>centratura</translation>
    </message>
    <message>
        <source>lay on face</source>
        <translation>appoggio su faccia</translation>
    </message>
    <message>
        <source>place on touched points</source>
        <translation>posa su punti toccati</translation>
    </message>
    <message>
        <source>move</source>
        <translation>spostamento</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>rotazione</translation>
    </message>
</context>
<context>
    <name>voluta::window::PartsView</name>
    <message>
        <source>Automatic</source>
        <translation>Automatico</translation>
    </message>
    <message>
        <source>Arrange parts</source>
        <translation>Disponi i pezzi</translation>
    </message>
    <message>
        <source>Arranging the copies…</source>
        <translation>Disposizione delle copie…</translation>
    </message>
    <message>
        <source>Number of copies</source>
        <translation>Numero di copie</translation>
    </message>
    <message numerus="yes">
        <source>%n copies on the plate</source>
        <translation>
            <numerusform>%n copia sul piatto</numerusform>
            <numerusform>%n copie sul piatto</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>voluta::window::PictureArea</name>
    <message>
        <source>The viewport needs OpenGL 3.2; this display offers %1. Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1. Planning and export work without a picture.</source>
        <translation>La vista richiede OpenGL 3.2; questo schermo offre %1. Aggiorna il driver grafico o imposta LIBGL_ALWAYS_SOFTWARE=1. Pianificazione ed esportazione funzionano anche senza vista.</translation>
    </message>
</context>
<context>
    <name>voluta::window::PieceCuts</name>
    <message>
        <source>keep cuts</source>
        <translation>tagli tenuti</translation>
    </message>
    <message>
        <source>search for cuts</source>
        <translation>ricerca dei tagli</translation>
    </message>
    <message>
        <source>move cut</source>
        <translation>spostamento del taglio</translation>
    </message>
    <message>
        <source>pick root</source>
        <translation>scelta della radice</translation>
    </message>
</context>
<context>
    <name>voluta::window::PreparePage</name>
    <message>
        <source>repair the mesh</source>
        <translation>riparazione della mesh</translation>
    </message>
    <message>
        <source>mesh as read</source>
        <translation>mesh come letta</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>cella</translation>
    </message>
    <message>
        <source>Edit cell</source>
        <translation>Modifica cella</translation>
    </message>
</context>
<context>
    <name>voluta::window::PresetBar</name>
    <message>
        <source>%1 (changed)</source>
        <translation>%1 (modificato)</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>Save, compare, export or import presets</source>
        <translation>Salva, confronta, esporta o importa preset</translation>
    </message>
    <message>
        <source>Preset menu</source>
        <translation>Menu dei preset</translation>
    </message>
</context>
<context>
    <name>voluta::window::PresetEditor</name>
    <message>
        <source>JSON files (*.json);;All files (*)</source>
        <translation>File JSON (*.json);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>In this project</source>
        <translation>In questo progetto</translation>
    </message>
    <message>
        <source>With the program</source>
        <translation>Con il programma</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>I tuoi</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1: %2 invece di %3</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>e %n altra</numerusform>
            <numerusform>e altre %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Change preset</source>
        <translation>Cambia preset</translation>
    </message>
    <message>
        <source>Settings of the preset were changed. Take the changes to %1?</source>
        <translation>Le impostazioni del preset sono state modificate. Portare le modifiche in %1?</translation>
    </message>
    <message>
        <source>&amp;Transfer</source>
        <translation>&amp;Trasferisci</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Scarta</translation>
    </message>
    <message>
        <source>&amp;Keep this preset</source>
        <translation>&amp;Mantieni questo preset</translation>
    </message>
    <message>
        <source>Preset %1</source>
        <translation>Preset %1</translation>
    </message>
    <message>
        <source>Save preset %1</source>
        <translation>Salva preset %1</translation>
    </message>
    <message>
        <source>%1, own</source>
        <translation>%1, proprio</translation>
    </message>
    <message>
        <source>Save preset as</source>
        <translation>Salva preset come</translation>
    </message>
    <message>
        <source>Rename preset</source>
        <translation>Rinomina preset</translation>
    </message>
    <message>
        <source>Rename preset %1</source>
        <translation>Rinomina preset %1</translation>
    </message>
    <message>
        <source>Delete preset</source>
        <translation>Elimina preset</translation>
    </message>
    <message>
        <source>Delete the preset %1? The settings of this project stay.</source>
        <translation>Eliminare il preset %1? Le impostazioni di questo progetto restano.</translation>
    </message>
    <message>
        <source>Delete preset %1</source>
        <translation>Elimina preset %1</translation>
    </message>
    <message>
        <source>Discard changes of the preset</source>
        <translation>Scarta le modifiche del preset</translation>
    </message>
    <message>
        <source>Present settings</source>
        <translation>Impostazioni attuali</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>Esporta %1</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>Importa un preset</translation>
    </message>
    <message>
        <source>Replace your own preset %1?</source>
        <translation>Sostituire il tuo preset %1?</translation>
    </message>
</context>
<context>
    <name>voluta::window::PresetNameDialog</name>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salva</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Rinomina</translation>
    </message>
</context>
<context>
    <name>voluta::window::ProjectFiles</name>
    <message>
        <source>settings of the sample</source>
        <translation>impostazioni dell&apos;esempio</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Apertura di %1</translation>
    </message>
    <message>
        <source>Ready. Press Plan.</source>
        <translation>Pronto. Premi Pianifica.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Interrotto.</translation>
    </message>
    <message>
        <source>%1 cannot be opened</source>
        <translation>Impossibile aprire %1</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Salvato %1</translation>
    </message>
    <message>
        <source>%1 is not saved</source>
        <translation>%1 non è stato salvato</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Apri recenti</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>Aperto %1</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Salva il progetto</translation>
    </message>
    <message>
        <source>Voluta projects (*.voluta)</source>
        <translation>Progetti Voluta (*.voluta)</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Recupera il lavoro non salvato</translation>
    </message>
    <message>
        <source>Voluta ended unexpectedly. A copy of “%1” was saved on %2.</source>
        <translation>Voluta si è chiuso in modo imprevisto. Di “%1” c&apos;è una copia del %2.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recupera</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Scarta</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Più tardi</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifiche non salvate</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
        <translation>“%1” ha modifiche non salvate.</translation>
    </message>
    <message>
        <source>Resume from here?</source>
        <translation>Riprendere da qui?</translation>
    </message>
    <message>
        <source>%1 % of the material counts as printed. The rest of “%2” opens as a new project.</source>
        <translation>Il %1 % del materiale conta come stampato. Il resto di «%2» si apre come nuovo progetto.</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Riprendi</translation>
    </message>
    <message>
        <source>Import a robot arm</source>
        <translation>Importa un braccio robotico</translation>
    </message>
    <message>
        <source>Robot descriptions (*.urdf *.xml);;All files (*)</source>
        <translation>Descrizioni di robot (*.urdf *.xml);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>No folder for your own robots: set HOME.</source>
        <translation>Nessuna cartella per i robot propri: imposta HOME.</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>cella</translation>
    </message>
    <message>
        <source>Imported: cell %1</source>
        <translation>Importata: cella %1</translation>
    </message>
    <message>
        <source>Add part</source>
        <translation>Aggiungi pezzo</translation>
    </message>
    <message>
        <source>Parts (%1);;All files (*)</source>
        <translation>Pezzi (%1);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>One part?</source>
        <translation>Un solo pezzo?</translation>
    </message>
    <message>
        <source>“%1” and “%2” in “%3” touch. Open the file as one part?</source>
        <translation>“%1” e “%2” in “%3” si toccano. Aprire il file come un solo pezzo?</translation>
    </message>
    <message>
        <source>One part</source>
        <translation>Un solo pezzo</translation>
    </message>
    <message>
        <source>Several parts</source>
        <translation>Più pezzi</translation>
    </message>
    <message>
        <source>Add or replace?</source>
        <translation>Aggiungere o sostituire?</translation>
    </message>
    <message>
        <source>Add “%1” beside “%2”, or open it instead?</source>
        <translation>Aggiungere «%1» accanto a «%2», o aprirlo al suo posto?</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Aggiungi</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Sostituisci</translation>
    </message>
    <message>
        <source>Parts and projects (%1);;All files (*)</source>
        <translation>Pezzi e progetti (%1);;Tutti i file (*)</translation>
    </message>
</context>
<context>
    <name>voluta::window::QuoteDialog</name>
    <message>
        <source>Quote</source>
        <translation>Preventivo</translation>
    </message>
    <message>
        <source>Price of each print, whatever its size</source>
        <translation>Prezzo di ogni stampa, qualunque sia la dimensione</translation>
    </message>
    <message>
        <source>Added to the cost</source>
        <translation>Aggiunto al costo</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Costo</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Voce</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Importo</translation>
    </message>
    <message>
        <source>Machine, per hour</source>
        <translation>Macchina, all&apos;ora</translation>
    </message>
    <message>
        <source>Set-up, per print</source>
        <translation>Preparazione, per stampa</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margine</translation>
    </message>
    <message>
        <source>Save page…</source>
        <translation>Salva la pagina…</translation>
    </message>
    <message>
        <source>A page for the customer, as PDF or HTML</source>
        <translation>Una pagina per il cliente, in PDF o HTML</translation>
    </message>
    <message>
        <source>%1 g at %2 per kg</source>
        <translation>%1 g a %2 al kg</translation>
    </message>
    <message>
        <source>%1 g; its price is not known</source>
        <translation>%1 g; il prezzo non è noto</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Preparazione</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Plan the part first.</source>
        <translation>Prima pianifica il pezzo.</translation>
    </message>
    <message>
        <source>Enter the price of the material under Processes and materials.</source>
        <translation>Inserisci il prezzo del materiale in Processi e materiali.</translation>
    </message>
    <message>
        <source>Save page</source>
        <translation>Salva la pagina</translation>
    </message>
    <message>
        <source>%1 quote</source>
        <translation>%1 preventivo</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;HTML (*.html)</source>
        <translation>PDF (*.pdf);;HTML (*.html)</translation>
    </message>
    <message>
        <source>Drawing the part…</source>
        <translation>Disegno del pezzo…</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Salvato come %1.</translation>
    </message>
    <message>
        <source>Price of an hour of the machine, with power and operator; each cell has its own</source>
        <translation>Prezzo di un&apos;ora di macchina, con energia e operatore; ogni cella ha il suo</translation>
    </message>
</context>
<context>
    <name>voluta::window::ReachView</name>
    <message>
        <source>move to best place</source>
        <translation>sposta al posto migliore</translation>
    </message>
</context>
<context>
    <name>voluta::window::RegionsTool</name>
    <message>
        <source>Move region</source>
        <translation>Sposta regione</translation>
    </message>
    <message>
        <source>Paint region</source>
        <translation>Dipingi regione</translation>
    </message>
    <message>
        <source>Add region</source>
        <translation>Aggiungi regione</translation>
    </message>
    <message>
        <source>Body of a region</source>
        <translation>Corpo di una regione</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Mesh (%1);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Lettura di %1…</translation>
    </message>
    <message>
        <source>Nothing is painted yet: the region has no effect.</source>
        <translation>Non è ancora dipinto nulla: la regione non ha effetto.</translation>
    </message>
</context>
<context>
    <name>voluta::window::RemedyEffect</name>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>Not covered</source>
        <translation>Non coperto</translation>
    </message>
    <message>
        <source>Printed in the air</source>
        <translation>Stampato in aria</translation>
    </message>
    <message>
        <source>Overfilled</source>
        <translation>Sovrariempito</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Applied: %1</source>
        <translation>Applicato: %1</translation>
    </message>
    <message>
        <source>It cannot be planned this way. Undo it, or try another remedy.</source>
        <translation>Così non si può pianificare. Annulla, o prova un altro rimedio.</translation>
    </message>
    <message>
        <source>The figures follow when the plan is done.</source>
        <translation>I valori seguono quando il piano è pronto.</translation>
    </message>
    <message>
        <source>Plan to see its effect.</source>
        <translation>Pianifica per vederne l&apos;effetto.</translation>
    </message>
    <message>
        <source>No longer found</source>
        <translation>Non più trovato</translation>
    </message>
    <message>
        <source>Unchanged: %1</source>
        <translation>Invariato: %1</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Prima: %1</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Dopo: %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::RunDialog</name>
    <message>
        <source>Path %1 mm over %2 mm</source>
        <translation>Percorso %1 mm su %2 mm</translation>
    </message>
    <message>
        <source>Speed %1 % over %2 mm</source>
        <translation>Velocità %1 % su %2 mm</translation>
    </message>
    <message>
        <source>Flow %1 % over %2 mm</source>
        <translation>Flusso %1 % su %2 mm</translation>
    </message>
    <message>
        <source>%1 mm of beads are missing</source>
        <translation>Mancano %1 mm di cordoni</translation>
    </message>
    <message>
        <source>Worst places</source>
        <translation>Punti peggiori</translation>
    </message>
    <message>
        <source>Recorded run %1</source>
        <translation>Esecuzione registrata %1</translation>
    </message>
    <message>
        <source>Comparing the record with the current plan…</source>
        <translation>Confronto della registrazione con il piano attuale…</translation>
    </message>
    <message>
        <source>Flow, recorded: mean %1 %, from %2 to %3 %</source>
        <translation>Flusso, registrato: media %1 %, da %2 a %3 %</translation>
    </message>
    <message>
        <source>Flow at this speed: mean %1 %, from %2 to %3 %</source>
        <translation>Flusso a questa velocità: media %1 %, da %2 a %3 %</translation>
    </message>
    <message>
        <source>Path: mean %1 mm, greatest %2 mm</source>
        <translation>Percorso: media %1 mm, massimo %2 mm</translation>
    </message>
    <message>
        <source>Speed: mean %1 %, from %2 to %3 %</source>
        <translation>Velocità: media %1 %, da %2 a %3 %</translation>
    </message>
    <message>
        <source>Beads recorded: %1 of %2 mm</source>
        <translation>Cordoni registrati: %1 di %2 mm</translation>
    </message>
</context>
<context>
    <name>voluta::window::Runs</name>
    <message>
        <source>1 voxel, %1 missed</source>
        <translation>1 voxel, mancati: %1</translation>
    </message>
    <message>
        <source>%1 voxels, %2 missed</source>
        <translation>%1 voxel, %2 mancati</translation>
    </message>
    <message>
        <source>%1 layers</source>
        <translation>%1 strati</translation>
    </message>
    <message>
        <source>1 waypoint</source>
        <translation>1 punto</translation>
    </message>
    <message>
        <source>%1 waypoints</source>
        <translation>%1 punti</translation>
    </message>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>replay passed</source>
        <translation>verifica superata</translation>
    </message>
    <message>
        <source>replay not passed</source>
        <translation>verifica non superata</translation>
    </message>
    <message>
        <source>Ready. Press Plan.</source>
        <translation>Pronto. Premi Pianifica.</translation>
    </message>
    <message>
        <source>Done. Blocking findings: %1.</source>
        <translation>Fatto. Segnalazioni bloccanti: %1.</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Fatto.</translation>
    </message>
    <message>
        <source>Pieces updated. Press Plan for layers and paths.</source>
        <translation>Pezzi aggiornati. Premi Pianifica per strati e percorsi.</translation>
    </message>
    <message>
        <source>Voxels updated. Press Plan for layers and paths.</source>
        <translation>Voxel aggiornati. Premi Pianifica per strati e percorsi.</translation>
    </message>
    <message>
        <source>Press Plan for layers and paths.</source>
        <translation>Premi Pianifica per strati e percorsi.</translation>
    </message>
    <message>
        <source>Compared. Select a row to adopt it.</source>
        <translation>Confronto fatto. Seleziona una riga per adottarla.</translation>
    </message>
    <message>
        <source>Preview: %1, 1 growth step</source>
        <translation>Anteprima: %1, 1 passo di crescita</translation>
    </message>
    <message>
        <source>Preview: %1, %2 growth steps</source>
        <translation>Anteprima: %1, %2 passi di crescita</translation>
    </message>
    <message>
        <source>Preview: %1, improving layers</source>
        <translation>Anteprima: %1, gli strati si affinano</translation>
    </message>
    <message>
        <source>Preview: %1. Press Plan.</source>
        <translation>Anteprima: %1. Premi Pianifica.</translation>
    </message>
    <message>
        <source>Out of date: %1</source>
        <translation>Non aggiornato: %1</translation>
    </message>
    <message>
        <source>1 piece</source>
        <translation>1 pezzo</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 pezzi</translation>
    </message>
    <message>
        <source>%1 mm² need support</source>
        <translation>%1 mm² da supportare</translation>
    </message>
    <message>
        <source>1 layer</source>
        <translation>1 strato</translation>
    </message>
    <message>
        <source>Cancelled. The previous results are still shown.</source>
        <translation>Annullato. Restano in vista i risultati precedenti.</translation>
    </message>
    <message>
        <source>Cancelled. Press Plan to start again.</source>
        <translation>Annullato. Premi Pianifica per ricominciare.</translation>
    </message>
    <message>
        <source>The run failed: see the findings.</source>
        <translation>L&apos;elaborazione è fallita: vedi le segnalazioni.</translation>
    </message>
    <message>
        <source>Cannot plan: correct the marked setting.</source>
        <translation>Impossibile pianificare: correggi l&apos;impostazione segnata.</translation>
    </message>
    <message>
        <source>planned time %1</source>
        <translation>tempo previsto %1</translation>
    </message>
    <message>
        <source>time on the controller %1</source>
        <translation>tempo sul controllore %1</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 pezzi</translation>
    </message>
    <message>
        <source>1 tool change</source>
        <translation>1 cambio utensile</translation>
    </message>
    <message>
        <source>%1 tool changes</source>
        <translation>%1 cambi utensile</translation>
    </message>
    <message>
        <source>not passed: blocking findings</source>
        <translation>non superato: segnalazioni bloccanti</translation>
    </message>
    <message>
        <source>safe to run, not as asked</source>
        <translation>sicuro da eseguire, non come richiesto</translation>
    </message>
    <message>
        <source>Done. Safe to run, not as asked: %1.</source>
        <translation>Fatto. Sicuro da eseguire, non come richiesto: %1.</translation>
    </message>
    <message>
        <source>safe to run but for your own statements</source>
        <translation>sicuro da eseguire, salvo le istruzioni proprie</translation>
    </message>
    <message>
        <source>Done. Safe to run but for your own statements.</source>
        <translation>Fatto. Sicuro da eseguire, salvo le istruzioni proprie.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ShortcutsDialog</name>
    <message>
        <source>Keys</source>
        <translation>Scorciatoie</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Cerca</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Tasti</translation>
    </message>
    <message>
        <source>Default key</source>
        <translation>Predefiniti</translation>
    </message>
    <message>
        <source>New key:</source>
        <translation>Nuovi tasti:</translation>
    </message>
    <message>
        <source>This key was removed from “%1”.</source>
        <translation>Questi tasti sono stati tolti da “%1”.</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nuovo tasto</translation>
    </message>
</context>
<context>
    <name>voluta::window::SimulatePage</name>
    <message>
        <source>Collision solids</source>
        <translation>Solidi di collisione</translation>
    </message>
    <message>
        <source>Shows the solids used for collision checks over the arm</source>
        <translation>Mostra sopra il braccio i solidi controllati per le collisioni</translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation>Esecuzione registrata</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tutti i file (*)</translation>
    </message>
    <message>
        <source>Follow the nozzle</source>
        <translation>Segui l&apos;ugello</translation>
    </message>
    <message>
        <source>Keeps the nozzle in the middle of the view</source>
        <translation>Tiene l&apos;ugello al centro della vista</translation>
    </message>
    <message>
        <source>Plan the motion before you jog the arm.</source>
        <translation>Pianifica il moto prima di muovere il braccio a mano.</translation>
    </message>
    <message>
        <source>Kinds of beads, with statistics</source>
        <translation>Tipi di cordoni, con statistiche</translation>
    </message>
    <message>
        <source>Colours the beads by kind, with time, share, length and mass of each</source>
        <translation>Colora i cordoni per tipo, con tempo, quota, lunghezza e massa di ciascuno</translation>
    </message>
    <message>
        <source>Jog the arm</source>
        <translation>Muovi il braccio a mano</translation>
    </message>
    <message>
        <source>Moves the arm by hand, by joints or by the nozzle. The plan stays as it is</source>
        <translation>Muove il braccio a mano, per giunti o per ugello. Il piano resta com&apos;è</translation>
    </message>
    <message>
        <source>Trace of the nozzle</source>
        <translation>Traccia dell&apos;ugello</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nessuno</translation>
    </message>
    <message>
        <source>Last %1 s</source>
        <translation>Ultimi %1 s</translation>
    </message>
    <message>
        <source>Whole print</source>
        <translation>Tutta la stampa</translation>
    </message>
    <message>
        <source>Solid where the nozzle prints, dashed where it travels</source>
        <translation>Continua dove l&apos;ugello stampa, tratteggiata dove si sposta</translation>
    </message>
    <message>
        <source>Remove the pause before layer %1</source>
        <translation>Rimuovi la pausa prima dello strato %1</translation>
    </message>
    <message>
        <source>Pause before layer %1</source>
        <translation>Pausa prima dello strato %1</translation>
    </message>
    <message>
        <source>Event before layer %1…</source>
        <translation>Evento prima dello strato %1…</translation>
    </message>
    <message>
        <source>Event before this layer…</source>
        <translation>Evento prima di questo strato…</translation>
    </message>
    <message>
        <source>A pause, a wait, an output, another tool or a line of your own</source>
        <translation>Una pausa, un&apos;attesa, un&apos;uscita, un altro utensile o una riga propria</translation>
    </message>
</context>
<context>
    <name>voluta::window::SizesDialog</name>
    <message>
        <source>Sizes from a measured plate</source>
        <translation>Misure da una piastra rilevata</translation>
    </message>
    <message>
        <source>Plate of %1</source>
        <translation>Piastra da %1</translation>
    </message>
    <message>
        <source>Print the sample plate (File &gt; Samples) with this process, and measure it.</source>
        <translation>Stampa la piastra di esempio (File &gt; Esempi) con questo processo e misurala.</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Nominale</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Rilevata</translation>
    </message>
    <message>
        <source>Use these sizes</source>
        <translation>Usa queste misure</translation>
    </message>
    <message>
        <source>Size factors %1 (x) and %2 (y), outlines %3, holes %4; the measured sizes fit within %5.</source>
        <translation>Fattori di misura %1 (x) e %2 (y), contorni %3, fori %4; le misure rilevate si adattano entro %5.</translation>
    </message>
</context>
<context>
    <name>voluta::window::SpacingView</name>
    <message>
        <source>%1–%2 mm: %3 % of the area</source>
        <translation>%1–%2 mm: %3 % dell&apos;area</translation>
    </message>
    <message>
        <source>Layer spacing, share of area by thickness [mm]</source>
        <translation>Spaziatura degli strati, quota d&apos;area per spessore [mm]</translation>
    </message>
    <message>
        <source>Mean %1 mm. Within %2–%3 mm: %4 %.</source>
        <translation>Media %1 mm. Entro %2–%3 mm: %4 %.</translation>
    </message>
    <message>
        <source>Too thin: %1 %.</source>
        <translation>Troppo sottile: %1 %.</translation>
    </message>
    <message>
        <source>Too thick: %1 %.</source>
        <translation>Troppo spesso: %1 %.</translation>
    </message>
</context>
<context>
    <name>voluta::window::StandChooser</name>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>change orientation</source>
        <translation>cambia orientamento</translation>
    </message>
</context>
<context>
    <name>voluta::window::StatusLine</name>
    <message>
        <source>about %1 left</source>
        <translation>circa %1 rimanenti</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
</context>
<context>
    <name>voluta::window::TogetherDialog</name>
    <message>
        <source>Print together with other machines</source>
        <translation>Stampa insieme ad altre macchine</translation>
    </message>
    <message>
        <source>Add project…</source>
        <translation>Aggiungi progetto…</translation>
    </message>
    <message>
        <source>Add this job again</source>
        <translation>Aggiungi ancora questo lavoro</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Save programs…</source>
        <translation>Salva i programmi…</translation>
    </message>
    <message>
        <source>Waits, and what they keep apart</source>
        <translation>Attese, e che cosa tengono separato</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Avvia o ferma</translation>
    </message>
    <message>
        <source>The programs were saved in %1.</source>
        <translation>I programmi sono stati salvati in %1.</translation>
    </message>
    <message>
        <source>Project of another machine</source>
        <translation>Progetto di un&apos;altra macchina</translation>
    </message>
    <message>
        <source>Voluta projects (*.voluta)</source>
        <translation>Progetti di Voluta (*.voluta)</translation>
    </message>
    <message>
        <source>Add the project of a machine that works beside this one.</source>
        <translation>Aggiungere il progetto di una macchina che lavora accanto a questa.</translation>
    </message>
    <message>
        <source>Place the machines, then find an order of work.</source>
        <translation>Posizionare le macchine, poi trovare un ordine di lavoro.</translation>
    </message>
    <message>
        <source>Together %1; one after the other %2; the longest alone %3</source>
        <translation>Insieme %1; una dopo l&apos;altra %2; la più lunga da sola %3</translation>
    </message>
    <message>
        <source>Start the programs in any order: each waits at its first point for the others, whatever their signals are, and ends with its signals off. If one is stopped, stop all, and start all again.</source>
        <translation>Avviare i programmi in qualsiasi ordine: ognuno attende gli altri al suo primo punto, qualunque sia lo stato dei segnali, e termina con i propri segnali disattivati. Se uno viene fermato, fermarli tutti e riavviarli tutti.</translation>
    </message>
    <message>
        <source>Machine %1: marks %2, waits %3, ends after %4</source>
        <translation>Macchina %1: segnali %2, attende %3, finisce dopo %4</translation>
    </message>
    <message>
        <source>Collision: %1 of machine %2 with %3 of machine %4</source>
        <translation>Urto: %1 della macchina %2 con %3 della macchina %4</translation>
    </message>
    <message>
        <source>Machine %1 waits %2 for machine %3</source>
        <translation>La macchina %1 attende %2 la macchina %3</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>Folder for all programs</source>
        <translation>Cartella per tutti i programmi</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Nota: %1</translation>
    </message>
    <message>
        <source>Move %1 mm further apart</source>
        <translation>Allontana di %1 mm</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Minimum distance %1 mm; collisions: %2</source>
        <translation>Distanza minima %1 mm; collisioni: %2</translation>
    </message>
    <message>
        <source>Schedule</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>Minimum clearance between arms</source>
        <translation>Distanza minima tra i bracci</translation>
    </message>
</context>
<context>
    <name>voluta::window::TouchDialog</name>
    <message>
        <source>Line %1 is not a point: write y and z, or x, y and z, in mm.</source>
        <translation>La riga %1 non è un punto: scrivi y e z, o x, y e z, in mm.</translation>
    </message>
    <message>
        <source>Place on touched points</source>
        <translation>Posa su punti toccati</translation>
    </message>
    <message>
        <source>Touch a cylinder along x at three points or more, and enter them in the work frame: y z, or x y z, one point per line [mm].</source>
        <translation>Tocca in tre o più punti un cilindro disteso lungo x e scrivili nel riferimento di lavoro: y z, o x y z, un punto per riga [mm].</translation>
    </message>
    <message>
        <source>y of the axis in the model</source>
        <translation>y dell’asse nel modello</translation>
    </message>
    <message>
        <source>z of the axis in the model</source>
        <translation>z dell’asse nel modello</translation>
    </message>
    <message>
        <source>Axis in the model (y, z)</source>
        <translation>Asse nel modello (y, z)</translation>
    </message>
    <message>
        <source>Move the part</source>
        <translation>Sposta il pezzo</translation>
    </message>
    <message>
        <source>Centre y %1, z %2 mm; radius %3 mm; points: %4, mean deviation %5 mm.</source>
        <translation>Centro y %1, z %2 mm; raggio %3 mm; punti: %4, scarto medio %5 mm.</translation>
    </message>
    <message>
        <source>The part is moved by y %1, z %2 mm.</source>
        <translation>Il pezzo si sposta di y %1, z %2 mm.</translation>
    </message>
    <message>
        <source>Touched points</source>
        <translation>Punti toccati</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledCanvas</name>
    <message>
        <source>→ around, ↑ along [mm]</source>
        <translation>→ intorno, ↑ lungo [mm]</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledDock</name>
    <message>
        <source>Layer %1 of %2</source>
        <translation>Strato %1 di %2</translation>
    </message>
    <message>
        <source>Unrolled layer</source>
        <translation>Strato srotolato</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledView</name>
    <message>
        <source>Wall</source>
        <translation>Parete</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>Riempimento</translation>
    </message>
    <message>
        <source>Gap fill</source>
        <translation>Riempimento vuoti</translation>
    </message>
    <message>
        <source>Skirt or brim</source>
        <translation>Skirt o brim</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Supporto</translation>
    </message>
    <message>
        <source>Around %1 mm (%2°), along %3 mm</source>
        <translation>Intorno %1 mm (%2°), lungo %3 mm</translation>
    </message>
    <message>
        <source>Around %1 mm, along %2 mm</source>
        <translation>Intorno %1 mm, lungo %2 mm</translation>
    </message>
    <message>
        <source>%1 %2, waypoint %3 of %4</source>
        <translation>%1 %2, punto %3 di %4</translation>
    </message>
    <message>
        <source>This layer is not wound around an axis.</source>
        <translation>Questo strato non è avvolto intorno a un asse.</translation>
    </message>
    <message>
        <source>Unrolled layer</source>
        <translation>Strato srotolato</translation>
    </message>
    <message>
        <source>Click a path to find it in the 3D view. Wheel zooms, drag moves, double click shows all.</source>
        <translation>Fai clic su un percorso per trovarlo nella vista 3D. La rotella ingrandisce, trascinare sposta, il doppio clic mostra tutto.</translation>
    </message>
    <message>
        <source>Prime</source>
        <translation>Innesco</translation>
    </message>
    <message>
        <source>Sparse infill</source>
        <translation>Riempimento rado</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Ponte</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Nastro</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Iniezione</translation>
    </message>
</context>
<context>
    <name>voluta::window::VerifyDialog</name>
    <message>
        <source>Replay findings</source>
        <translation>Segnalazioni della verifica</translation>
    </message>
    <message>
        <source>Verify %1</source>
        <translation>Verifica %1</translation>
    </message>
    <message>
        <source>Replaying the program against the current plan…</source>
        <translation>Il programma viene rieseguito e confrontato con il piano attuale…</translation>
    </message>
    <message>
        <source>%1: passed. The program matches the plan.</source>
        <translation>%1: accettato. Il programma corrisponde al piano.</translation>
    </message>
    <message>
        <source>%1: refused. Do not run it on the robot.</source>
        <translation>%1: rifiutato. Non eseguirlo sul robot.</translation>
    </message>
    <message>
        <source>Replay findings, the first %1 of %2</source>
        <translation>Segnalazioni della verifica, le prime %1 di %2</translation>
    </message>
    <message>
        <source>%1: safe to run, but it does not print the part as asked.</source>
        <translation>%1: sicuro da eseguire, ma non stampa il pezzo come richiesto.</translation>
    </message>
    <message>
        <source>%1: safe to run but for your own statements, which nothing checks.</source>
        <translation>%1: sicuro da eseguire, salvo le istruzioni proprie, che nulla controlla.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ViewOptions</name>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Colora per</translation>
    </message>
    <message>
        <source>Latest</source>
        <translation>Ultimo</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Strati</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Percorsi</translation>
    </message>
    <message>
        <source>The latest result of the plan</source>
        <translation>L&apos;ultimo risultato del piano</translation>
    </message>
    <message>
        <source>Layers drawn with their thickness</source>
        <translation>Strati disegnati con il loro spessore</translation>
    </message>
    <message>
        <source>Tool-paths drawn as beads</source>
        <translation>Percorsi utensile disegnati come cordoni</translation>
    </message>
    <message>
        <source>Part surface</source>
        <translation>Superficie del pezzo</translation>
    </message>
    <message>
        <source>Travel moves</source>
        <translation>Spostamenti a vuoto</translation>
    </message>
    <message>
        <source>True bead width</source>
        <translation>Larghezza reale dei cordoni</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Piano di sezione</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Inverti</translation>
    </message>
    <message>
        <source>Remove the other side</source>
        <translation>Togli l&apos;altro lato</translation>
    </message>
    <message>
        <source>Position of the section plane</source>
        <translation>Posizione del piano di sezione</translation>
    </message>
    <message>
        <source>Solid voxels and their growth order</source>
        <translation>Voxel solidi e il loro ordine di crescita</translation>
    </message>
    <message>
        <source>Convex front</source>
        <translation>Fronte convesso</translation>
    </message>
    <message>
        <source>During growth replay: the convex front; the next voxels must be outside it</source>
        <translation>Nella crescita riprodotta: il fronte convesso; i prossimi voxel devono esserne fuori</translation>
    </message>
    <message>
        <source>Later voxels faint</source>
        <translation>Voxel futuri velati</translation>
    </message>
    <message>
        <source>During growth replay: voxels not yet printed</source>
        <translation>Mentre si rivede la crescita: i voxel non ancora stampati</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pezzi</translation>
    </message>
    <message>
        <source>Pieces printable without support, and their base planes</source>
        <translation>Pezzi stampabili senza supporto, e i loro piani di base</translation>
    </message>
</context>
<context>
    <name>voluta::window::Welcome</name>
    <message>
        <source>Print a part with a robot</source>
        <translation>Stampa un pezzo con un robot</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Vista non disponibile</translation>
    </message>
    <message>
        <source>Drop a mesh (STL, OBJ, PLY, OFF or 3MF), a slicer&apos;s G-code or a Voluta project here.</source>
        <translation>Trascina qui una mesh (STL, OBJ, PLY, OFF o 3MF), il G-code di uno slicer o un progetto Voluta.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Apri…</translation>
    </message>
    <message>
        <source>Sample vase</source>
        <translation>Vaso di esempio</translation>
    </message>
</context>
</TS>
