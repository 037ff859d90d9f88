-- SPDX-License-Identifier: Apache-2.0
-- The lexicon of lexicon_sample.h in the second schema, as the program of that time wrote it.
PRAGMA foreign_keys = OFF;
PRAGMA application_id = 1095396472;
PRAGMA user_version = 2;
BEGIN TRANSACTION;
CREATE TABLE feature (
  gloss TEXT NOT NULL REFERENCES sign (gloss) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  tier TEXT NOT NULL,
  word TEXT NOT NULL CHECK (word <> ''),
  from_share REAL NOT NULL CHECK (from_share BETWEEN 0 AND 1),
  to_share REAL NOT NULL CHECK (to_share BETWEEN from_share AND 1),
  amount REAL NOT NULL CHECK (amount BETWEEN 0 AND 4),
  PRIMARY KEY (gloss, position)) STRICT, WITHOUT ROWID;
CREATE TABLE finger (
  handshape TEXT NOT NULL REFERENCES handshape (id) ON DELETE CASCADE,
  digit INTEGER NOT NULL CHECK (digit BETWEEN 0 AND 3),
  mcp REAL NOT NULL,
  pip REAL NOT NULL,
  dip REAL NOT NULL,
  abduction REAL NOT NULL,
  PRIMARY KEY (handshape, digit)) STRICT, WITHOUT ROWID;
INSERT INTO "finger" VALUES('flat',0,0.0,0.0,0.0,2.0);
INSERT INTO "finger" VALUES('flat',1,0.0,0.0,0.0,0.0);
INSERT INTO "finger" VALUES('flat',2,0.0,0.0,0.0,2.0);
INSERT INTO "finger" VALUES('flat',3,0.0,0.0,0.5,4.0);
CREATE TABLE handshape (
  id TEXT PRIMARY KEY NOT NULL,
  position INTEGER NOT NULL UNIQUE,
  name TEXT NOT NULL,
  base TEXT NOT NULL REFERENCES handshape (id) DEFERRABLE INITIALLY DEFERRED,
  selected TEXT NOT NULL,
  thumb_radial REAL NOT NULL,
  thumb_palmar REAL NOT NULL,
  thumb_opposition REAL NOT NULL CHECK (thumb_opposition BETWEEN 0 AND 1),
  thumb_mp REAL NOT NULL,
  thumb_ip REAL NOT NULL,
  hamnosys TEXT NOT NULL,
  description TEXT NOT NULL,
  aliases TEXT NOT NULL,
  sources TEXT NOT NULL,
  form_evidence TEXT NOT NULL,
  movement_evidence TEXT NOT NULL,
  confidence TEXT NOT NULL CHECK (confidence IN ('low', 'medium', 'high')),
  review TEXT NOT NULL CHECK (review IN ('unreviewed', 'reviewed', 'rejected')),
  reviewed_by TEXT NOT NULL CHECK ((reviewed_by = '') = (review = 'unreviewed')),
  reviewed_on TEXT NOT NULL CHECK ((reviewed_on = '') = (review = 'unreviewed'))) STRICT;
INSERT INTO "handshape" VALUES('flat',0,'Flat','flat','all',20.0,10.0,0.25,5.0,0.0,'hamflathand','Straight fingers side by side.','B
paper "hand"','memory','','','high','unreviewed','','');
CREATE TABLE keyword (
  position INTEGER PRIMARY KEY NOT NULL,
  word TEXT NOT NULL CHECK (word <> ''),
  part_of_speech TEXT NOT NULL CHECK (part_of_speech IN ('', 'noun', 'verb', 'adj', 'adv', 'pron', 'wh', 'num', 'neg', 'modal', 'interj', 'prep', 'conj', 'det')),
  gloss TEXT NOT NULL REFERENCES sign (gloss) ON DELETE CASCADE,
  rank INTEGER NOT NULL CHECK (rank BETWEEN 0 AND 99),
  UNIQUE (word, part_of_speech, rank)) STRICT;
INSERT INTO "keyword" VALUES(0,'hurt','verb','HURT',0);
INSERT INTO "keyword" VALUES(1,'sore','adj','HURT',1);
CREATE TABLE movement (
  gloss TEXT NOT NULL REFERENCES sign (gloss) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  kind TEXT NOT NULL CHECK (kind IN ('hold', 'straight', 'arc', 'circle', 'spiral', 'zigzag', 'wavy', 'tap', 'brush', 'rub', 'twist', 'nod', 'swing', 'stir', 'shake', 'sway', 'bounce', 'open', 'close', 'flick', 'squeeze', 'wiggle', 'bend', 'alternate', 'cross', 'separate', 'approach', 'strike')),
  direction TEXT,
  size TEXT NOT NULL CHECK (size IN ('tiny', 'small', 'medium', 'large')),
  repeats INTEGER NOT NULL CHECK (repeats BETWEEN 1 AND 24),
  hands TEXT NOT NULL CHECK (hands IN ('dom', 'nd', 'both', 'alt')),
  manner TEXT NOT NULL CHECK (manner IN ('plain', 'slow', 'fast', 'sharp', 'tense', 'rest')),
  plane TEXT NOT NULL CHECK (plane IN ('none', 'horizontal', 'vertical', 'frontal', 'sagittal', 'supinate', 'pronate', 'side_to_side', 'up_down', 'to_fro', 'fingers', 'cw', 'ccw')),
  bow TEXT,
  start TEXT,
  eighths INTEGER NOT NULL CHECK (eighths BETWEEN 1 AND 64),
  ellipse TEXT,
  flattening TEXT NOT NULL CHECK (flattening IN ('tiny', 'small', 'medium', 'large')),
  growth TEXT NOT NULL CHECK (growth IN ('none', 'increasing', 'decreasing')),
  digits TEXT NOT NULL,
  pace REAL NOT NULL CHECK (pace BETWEEN 0.1 AND 10),
  from_phase INTEGER NOT NULL CHECK (from_phase >= 0),
  to_phase INTEGER NOT NULL CHECK (to_phase >= from_phase),
  PRIMARY KEY (gloss, position)) STRICT, WITHOUT ROWID;
INSERT INTO "movement" VALUES('HURT',0,'shake',NULL,'small',3,'both','fast','up_down',NULL,NULL,8,NULL,'medium','none','',1.0,0,1);
INSERT INTO "movement" VALUES('HURT',1,'straight','left-down','medium',1,'dom','plain','none',NULL,NULL,8,NULL,'medium','none','',1.0,1,1);
CREATE TABLE phrase (
  id TEXT PRIMARY KEY NOT NULL,
  position INTEGER NOT NULL UNIQUE,
  domain TEXT NOT NULL,
  english TEXT NOT NULL CHECK (english <> ''),
  notes TEXT NOT NULL,
  sources TEXT NOT NULL,
  form_evidence TEXT NOT NULL,
  movement_evidence TEXT NOT NULL,
  confidence TEXT NOT NULL CHECK (confidence IN ('low', 'medium', 'high')),
  review TEXT NOT NULL CHECK (review IN ('unreviewed', 'reviewed', 'rejected')),
  reviewed_by TEXT NOT NULL CHECK ((reviewed_by = '') = (review = 'unreviewed')),
  reviewed_on TEXT NOT NULL CHECK ((reviewed_on = '') = (review = 'unreviewed'))) STRICT;
INSERT INTO "phrase" VALUES('i-hurt',0,'hospital','I hurt, {NAME}.','A note.','grammar','','','medium','unreviewed','','');
CREATE TABLE phrase_item (
  phrase TEXT NOT NULL REFERENCES phrase (id) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  item TEXT NOT NULL CHECK (item <> ''),
  PRIMARY KEY (phrase, position)) STRICT, WITHOUT ROWID;
INSERT INTO "phrase_item" VALUES('i-hurt',0,'HURT');
INSERT INTO "phrase_item" VALUES('i-hurt',1,'{NAME}');
INSERT INTO "phrase_item" VALUES('i-hurt',2,'fs:X-RAY');
INSERT INTO "phrase_item" VALUES('i-hurt',3,'num:10');
CREATE TABLE phrase_span (
  phrase TEXT NOT NULL REFERENCES phrase (id) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  kind TEXT NOT NULL CHECK (kind IN ('topic', 'yn', 'wh', 'neg', 'cond', 'aff', 'cmd', 'polite')),
  from_item INTEGER NOT NULL CHECK (from_item >= 0),
  to_item INTEGER NOT NULL CHECK (to_item >= from_item),
  brows TEXT NOT NULL CHECK (brows IN ('', 'raise', 'raise-slight', 'furrow', 'furrow-slight', 'inner-raise', 'raise-left', 'raise-right', 'neutral')),
  head TEXT NOT NULL CHECK (head IN ('', 'shake', 'nod', 'nod-slight', 'tilt', 'tilt-slight', 'tilt-forward', 'tilt-back-slight', 'forward', 'sway', 'nod-up', 'tilt-left', 'turn-left', 'turn-right', 'back', 'follow-gaze', 'straight', 'lean-forward', 'lean-back', 'lean-left', 'lean-right', 'body-left', 'body-right', 'sigh', 'heave', 'rounded')),
  gaze TEXT NOT NULL CHECK (gaze IN ('', 'addressee', 'down-to-hand', 'down-to-other-hand', 'down', 'up', 'left', 'right', 'left-up', 'left-down', 'right-up', 'right-down', 'far', 'unfocused', 'rolling')),
  mouth TEXT NOT NULL CHECK (mouth IN ('', 'smile', 'smile-slight', 'down-turned', 'teeth-showing', 'pressed', 'pursed', 'open', 'open-close', 'blow', 'ow', 'breathe', 'exhale', 'stretched', 'puffed', 'cough', 'shh', 'D01', 'D02', 'D03', 'D04', 'D05', 'D06', 'D07', 'D08', 'D09', 'J01', 'J02', 'J03', 'J04', 'L01', 'L02', 'L03', 'L04', 'L05', 'L06', 'L07', 'L08', 'L09', 'L10', 'L11', 'L12', 'L13', 'L14', 'L15', 'L16', 'L17', 'L18', 'L19', 'L20', 'L21', 'L22', 'L23', 'L24', 'L25', 'L26', 'L27', 'L28', 'L29', 'L30', 'L31', 'L32', 'L33', 'L34', 'L35', 'C01', 'C02', 'C03', 'C04', 'C05', 'C06', 'C07', 'C08', 'C09', 'C10', 'C11', 'C12', 'C13', 'T01', 'T02', 'T03', 'T04', 'T05', 'T06', 'T07', 'T08', 'T09', 'T10', 'T11', 'T12', 'T13', 'T14', 'T15', 'T16', 'T17')),
  eyes TEXT NOT NULL CHECK (eyes IN ('', 'wide', 'closed', 'narrow', 'half-closed', 'squint', 'blink', 'wide-left', 'wide-right', 'closed-left', 'closed-right', 'narrow-left', 'narrow-right', 'squint-left', 'squint-right')),
  ending TEXT NOT NULL CHECK (ending IN ('', 'hold last sign', 'pause/blink')),
  PRIMARY KEY (phrase, position)) STRICT, WITHOUT ROWID;
INSERT INTO "phrase_span" VALUES('i-hurt',0,'wh',0,1,'furrow','tilt-forward','addressee','','','hold last sign');
CREATE TABLE posture (
  gloss TEXT NOT NULL REFERENCES sign (gloss) ON DELETE CASCADE,
  hand TEXT NOT NULL CHECK (hand IN ('dominant', 'base')),
  phase INTEGER NOT NULL CHECK (phase BETWEEN 0 AND 95),
  handshape TEXT NOT NULL REFERENCES handshape (id),
  fingers TEXT NOT NULL,
  palm TEXT NOT NULL,
  location TEXT NOT NULL CHECK (location IN ('top_head', 'forehead', 'eyebrow', 'temple', 'side_head', 'eye', 'cheekbone', 'nose', 'nostrils', 'face', 'cheek', 'ear', 'earlobe', 'contra_ear', 'upper_lip', 'mouth', 'teeth', 'tongue', 'lower_lip', 'chin', 'under_chin', 'neck', 'shoulder', 'contra_shoulder', 'upper_chest', 'chest', 'contra_chest', 'stomach', 'lower_stomach', 'waist', 'thigh', 'upper_arm', 'elbow', 'high_neutral', 'neutral', 'low_neutral', 'ipsi_space', 'contra_space', 'nd_palm', 'nd_back', 'nd_wrist_back', 'nd_wrist_inner', 'nd_forearm_back', 'nd_forearm_inner', 'nd_fingertips', 'nd_thumb', 'nd_index', 'nd_middle', 'nd_ring', 'nd_little', 'nd_ulnar', 'nd_radial', 'nd_fist_top', 'nd_elbow', 'hands', 'nd_thumb_ball', 'nd_wrist_radial', 'nd_wrist_ulnar', 'nd_elbow_inside', 'nd_thumb_fingertip', 'nd_thumb_nail', 'nd_thumb_tip_pad', 'nd_thumb_tip_radial', 'nd_thumb_tip_ulnar', 'nd_thumb_mid_palmar', 'nd_thumb_mid_dorsal', 'nd_thumb_mid_radial', 'nd_thumb_mid_ulnar', 'nd_thumb_base_palmar', 'nd_thumb_base_dorsal', 'nd_thumb_base_radial', 'nd_thumb_base_ulnar', 'nd_thumb_length_palmar', 'nd_thumb_length_dorsal', 'nd_thumb_length_radial', 'nd_thumb_length_ulnar', 'nd_index_fingertip', 'nd_index_nail', 'nd_index_tip_pad', 'nd_index_tip_radial', 'nd_index_tip_ulnar', 'nd_index_mid_palmar', 'nd_index_mid_dorsal', 'nd_index_mid_radial', 'nd_index_mid_ulnar', 'nd_index_base_palmar', 'nd_index_base_dorsal', 'nd_index_base_radial', 'nd_index_base_ulnar', 'nd_index_length_palmar', 'nd_index_length_dorsal', 'nd_index_length_radial', 'nd_index_length_ulnar', 'nd_middle_fingertip', 'nd_middle_nail', 'nd_middle_tip_pad', 'nd_middle_tip_radial', 'nd_middle_tip_ulnar', 'nd_middle_mid_palmar', 'nd_middle_mid_dorsal', 'nd_middle_mid_radial', 'nd_middle_mid_ulnar', 'nd_middle_base_palmar', 'nd_middle_base_dorsal', 'nd_middle_base_radial', 'nd_middle_base_ulnar', 'nd_middle_length_palmar', 'nd_middle_length_dorsal', 'nd_middle_length_radial', 'nd_middle_length_ulnar', 'nd_ring_fingertip', 'nd_ring_nail', 'nd_ring_tip_pad', 'nd_ring_tip_radial', 'nd_ring_tip_ulnar', 'nd_ring_mid_palmar', 'nd_ring_mid_dorsal', 'nd_ring_mid_radial', 'nd_ring_mid_ulnar', 'nd_ring_base_palmar', 'nd_ring_base_dorsal', 'nd_ring_base_radial', 'nd_ring_base_ulnar', 'nd_ring_length_palmar', 'nd_ring_length_dorsal', 'nd_ring_length_radial', 'nd_ring_length_ulnar', 'nd_little_fingertip', 'nd_little_nail', 'nd_little_tip_pad', 'nd_little_tip_radial', 'nd_little_tip_ulnar', 'nd_little_mid_palmar', 'nd_little_mid_dorsal', 'nd_little_mid_radial', 'nd_little_mid_ulnar', 'nd_little_base_palmar', 'nd_little_base_dorsal', 'nd_little_base_radial', 'nd_little_base_ulnar', 'nd_little_length_palmar', 'nd_little_length_dorsal', 'nd_little_length_radial', 'nd_little_length_ulnar')),
  offset_left REAL NOT NULL,
  offset_up REAL NOT NULL,
  offset_away REAL NOT NULL,
  contact TEXT CHECK (contact IN ('touch', 'hold', 'brush', 'near', 'interlock', 'cross')),
  contact_part TEXT CHECK (contact_part IN ('palm', 'back', 'radial', 'ulnar', 'fingertips', 'index_tip', 'middle_tip', 'ring_tip', 'little_tip', 'thumb_tip', 'thumb_index_tips', 'index_middle_tips', 'index_side', 'index_middle', 'fingers', 'index_knuckle', 'knuckles', 'wrist', 'fist_thumb_side', 'fist_ulnar', 'thumb_web', 'index_base', 'index_mid_joint', 'thumb_side', 'index_pad', 'thumb_ball', 'wrist_back', 'wrist_radial', 'wrist_ulnar', 'forearm', 'thumb_fingertip', 'thumb_nail', 'thumb_tip_pad', 'thumb_tip_radial', 'thumb_tip_ulnar', 'thumb_mid_palmar', 'thumb_mid_dorsal', 'thumb_mid_radial', 'thumb_mid_ulnar', 'thumb_base_palmar', 'thumb_base_dorsal', 'thumb_base_radial', 'thumb_base_ulnar', 'thumb_length_palmar', 'thumb_length_dorsal', 'thumb_length_radial', 'thumb_length_ulnar', 'index_fingertip', 'index_nail', 'index_tip_pad', 'index_tip_radial', 'index_tip_ulnar', 'index_mid_palmar', 'index_mid_dorsal', 'index_mid_radial', 'index_mid_ulnar', 'index_base_palmar', 'index_base_dorsal', 'index_base_radial', 'index_base_ulnar', 'index_length_palmar', 'index_length_dorsal', 'index_length_radial', 'index_length_ulnar', 'middle_fingertip', 'middle_nail', 'middle_tip_pad', 'middle_tip_radial', 'middle_tip_ulnar', 'middle_mid_palmar', 'middle_mid_dorsal', 'middle_mid_radial', 'middle_mid_ulnar', 'middle_base_palmar', 'middle_base_dorsal', 'middle_base_radial', 'middle_base_ulnar', 'middle_length_palmar', 'middle_length_dorsal', 'middle_length_radial', 'middle_length_ulnar', 'ring_fingertip', 'ring_nail', 'ring_tip_pad', 'ring_tip_radial', 'ring_tip_ulnar', 'ring_mid_palmar', 'ring_mid_dorsal', 'ring_mid_radial', 'ring_mid_ulnar', 'ring_base_palmar', 'ring_base_dorsal', 'ring_base_radial', 'ring_base_ulnar', 'ring_length_palmar', 'ring_length_dorsal', 'ring_length_radial', 'ring_length_ulnar', 'little_fingertip', 'little_nail', 'little_tip_pad', 'little_tip_radial', 'little_tip_ulnar', 'little_mid_palmar', 'little_mid_dorsal', 'little_mid_radial', 'little_mid_ulnar', 'little_base_palmar', 'little_base_dorsal', 'little_base_radial', 'little_base_ulnar', 'little_length_palmar', 'little_length_dorsal', 'little_length_radial', 'little_length_ulnar')),
  contact_target TEXT CHECK (contact_target IN ('top_head', 'forehead', 'eyebrow', 'temple', 'side_head', 'eye', 'cheekbone', 'nose', 'nostrils', 'face', 'cheek', 'ear', 'earlobe', 'contra_ear', 'upper_lip', 'mouth', 'teeth', 'tongue', 'lower_lip', 'chin', 'under_chin', 'neck', 'shoulder', 'contra_shoulder', 'upper_chest', 'chest', 'contra_chest', 'stomach', 'lower_stomach', 'waist', 'thigh', 'upper_arm', 'elbow', 'high_neutral', 'neutral', 'low_neutral', 'ipsi_space', 'contra_space', 'nd_palm', 'nd_back', 'nd_wrist_back', 'nd_wrist_inner', 'nd_forearm_back', 'nd_forearm_inner', 'nd_fingertips', 'nd_thumb', 'nd_index', 'nd_middle', 'nd_ring', 'nd_little', 'nd_ulnar', 'nd_radial', 'nd_fist_top', 'nd_elbow', 'hands', 'nd_thumb_ball', 'nd_wrist_radial', 'nd_wrist_ulnar', 'nd_elbow_inside', 'nd_thumb_fingertip', 'nd_thumb_nail', 'nd_thumb_tip_pad', 'nd_thumb_tip_radial', 'nd_thumb_tip_ulnar', 'nd_thumb_mid_palmar', 'nd_thumb_mid_dorsal', 'nd_thumb_mid_radial', 'nd_thumb_mid_ulnar', 'nd_thumb_base_palmar', 'nd_thumb_base_dorsal', 'nd_thumb_base_radial', 'nd_thumb_base_ulnar', 'nd_thumb_length_palmar', 'nd_thumb_length_dorsal', 'nd_thumb_length_radial', 'nd_thumb_length_ulnar', 'nd_index_fingertip', 'nd_index_nail', 'nd_index_tip_pad', 'nd_index_tip_radial', 'nd_index_tip_ulnar', 'nd_index_mid_palmar', 'nd_index_mid_dorsal', 'nd_index_mid_radial', 'nd_index_mid_ulnar', 'nd_index_base_palmar', 'nd_index_base_dorsal', 'nd_index_base_radial', 'nd_index_base_ulnar', 'nd_index_length_palmar', 'nd_index_length_dorsal', 'nd_index_length_radial', 'nd_index_length_ulnar', 'nd_middle_fingertip', 'nd_middle_nail', 'nd_middle_tip_pad', 'nd_middle_tip_radial', 'nd_middle_tip_ulnar', 'nd_middle_mid_palmar', 'nd_middle_mid_dorsal', 'nd_middle_mid_radial', 'nd_middle_mid_ulnar', 'nd_middle_base_palmar', 'nd_middle_base_dorsal', 'nd_middle_base_radial', 'nd_middle_base_ulnar', 'nd_middle_length_palmar', 'nd_middle_length_dorsal', 'nd_middle_length_radial', 'nd_middle_length_ulnar', 'nd_ring_fingertip', 'nd_ring_nail', 'nd_ring_tip_pad', 'nd_ring_tip_radial', 'nd_ring_tip_ulnar', 'nd_ring_mid_palmar', 'nd_ring_mid_dorsal', 'nd_ring_mid_radial', 'nd_ring_mid_ulnar', 'nd_ring_base_palmar', 'nd_ring_base_dorsal', 'nd_ring_base_radial', 'nd_ring_base_ulnar', 'nd_ring_length_palmar', 'nd_ring_length_dorsal', 'nd_ring_length_radial', 'nd_ring_length_ulnar', 'nd_little_fingertip', 'nd_little_nail', 'nd_little_tip_pad', 'nd_little_tip_radial', 'nd_little_tip_ulnar', 'nd_little_mid_palmar', 'nd_little_mid_dorsal', 'nd_little_mid_radial', 'nd_little_mid_ulnar', 'nd_little_base_palmar', 'nd_little_base_dorsal', 'nd_little_base_radial', 'nd_little_base_ulnar', 'nd_little_length_palmar', 'nd_little_length_dorsal', 'nd_little_length_radial', 'nd_little_length_ulnar')),
  PRIMARY KEY (gloss, hand, phase)) STRICT, WITHOUT ROWID;
INSERT INTO "posture" VALUES('HURT','base',0,'flat','right','up','neutral',0.04,0.0,0.16,NULL,NULL,NULL);
INSERT INTO "posture" VALUES('HURT','dominant',0,'flat','left-up','toward','nd_palm',-0.08,0.065,0.001,'touch','index_tip','nd_thumb');
INSERT INTO "posture" VALUES('HURT','dominant',1,'flat','left','toward','neutral',0.0,0.0,0.2,NULL,NULL,NULL);
CREATE TABLE sign (
  gloss TEXT PRIMARY KEY NOT NULL,
  position INTEGER NOT NULL UNIQUE,
  kind TEXT NOT NULL CHECK (kind IN ('sign', 'letter', 'number')),
  category TEXT NOT NULL,
  region TEXT NOT NULL,
  definition TEXT NOT NULL CHECK (definition <> ''),
  handedness TEXT NOT NULL CHECK (handedness IN ('one', 'two-symmetric', 'two-alternating', 'dominant+base')),
  brows TEXT NOT NULL CHECK (brows IN ('', 'raise', 'raise-slight', 'furrow', 'furrow-slight', 'inner-raise', 'raise-left', 'raise-right', 'neutral')),
  eyes TEXT NOT NULL CHECK (eyes IN ('', 'wide', 'closed', 'narrow', 'half-closed', 'squint', 'blink', 'wide-left', 'wide-right', 'closed-left', 'closed-right', 'narrow-left', 'narrow-right', 'squint-left', 'squint-right')),
  mouth TEXT NOT NULL CHECK (mouth IN ('', 'smile', 'smile-slight', 'down-turned', 'teeth-showing', 'pressed', 'pursed', 'open', 'open-close', 'blow', 'ow', 'breathe', 'exhale', 'stretched', 'puffed', 'cough', 'shh', 'D01', 'D02', 'D03', 'D04', 'D05', 'D06', 'D07', 'D08', 'D09', 'J01', 'J02', 'J03', 'J04', 'L01', 'L02', 'L03', 'L04', 'L05', 'L06', 'L07', 'L08', 'L09', 'L10', 'L11', 'L12', 'L13', 'L14', 'L15', 'L16', 'L17', 'L18', 'L19', 'L20', 'L21', 'L22', 'L23', 'L24', 'L25', 'L26', 'L27', 'L28', 'L29', 'L30', 'L31', 'L32', 'L33', 'L34', 'L35', 'C01', 'C02', 'C03', 'C04', 'C05', 'C06', 'C07', 'C08', 'C09', 'C10', 'C11', 'C12', 'C13', 'T01', 'T02', 'T03', 'T04', 'T05', 'T06', 'T07', 'T08', 'T09', 'T10', 'T11', 'T12', 'T13', 'T14', 'T15', 'T16', 'T17')),
  cheeks TEXT NOT NULL CHECK (cheeks IN ('', 'puffed')),
  head TEXT NOT NULL CHECK (head IN ('', 'shake', 'nod', 'nod-slight', 'tilt', 'tilt-slight', 'tilt-forward', 'tilt-back-slight', 'forward', 'sway', 'nod-up', 'tilt-left', 'turn-left', 'turn-right', 'back', 'follow-gaze', 'straight', 'lean-forward', 'lean-back', 'lean-left', 'lean-right', 'body-left', 'body-right', 'sigh', 'heave', 'rounded')),
  shoulders TEXT NOT NULL CHECK (shoulders IN ('', 'hunched', 'shrug', 'drop', 'hunched-left', 'hunched-right', 'shrug-left', 'shrug-right', 'raised', 'raised-left', 'raised-right')),
  gaze TEXT NOT NULL CHECK (gaze IN ('', 'addressee', 'down-to-hand', 'down-to-other-hand', 'down', 'up', 'left', 'right', 'left-up', 'left-down', 'right-up', 'right-down', 'far', 'unfocused', 'rolling')),
  face TEXT NOT NULL CHECK (face IN ('', 'pained', 'dislike', 'nose-wrinkled', 'nose-twitch', 'nose-widened')),
  mouthing TEXT NOT NULL,
  sources TEXT NOT NULL,
  form_evidence TEXT NOT NULL,
  movement_evidence TEXT NOT NULL,
  confidence TEXT NOT NULL CHECK (confidence IN ('low', 'medium', 'high')),
  review TEXT NOT NULL CHECK (review IN ('unreviewed', 'reviewed', 'rejected')),
  reviewed_by TEXT NOT NULL CHECK ((reviewed_by = '') = (review = 'unreviewed')),
  reviewed_on TEXT NOT NULL CHECK ((reviewed_on = '') = (review = 'unreviewed'))) STRICT;
INSERT INTO "sign" VALUES('HURT',0,'sign','health','north','How it looks.','dominant+base','furrow','','','','','','','pained','hurt','memory,iconic','one source','memory only','low','unreviewed','','');
COMMIT;
