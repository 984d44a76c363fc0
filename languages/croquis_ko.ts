<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko" sourcelanguage="en">
<context>
    <name>Croquis</name>
    <message>
        <source>Projects (*.croq)</source>
        <translation>프로젝트 (*.croq)</translation>
    </message>
    <message>
        <source>Earlier versions of projects (*.croq~*)</source>
        <translation>프로젝트의 이전 버전 (*.croq~*)</translation>
    </message>
    <message>
        <source>Drawings and networks of curves (*.svg *.json)</source>
        <translation>드로잉 및 커브 네트워크 (*.svg *.json)</translation>
    </message>
    <message>
        <source>Cameras (*.fspy *.json)</source>
        <translation>카메라 (*.fspy *.json)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>이미지 (%1)</translation>
    </message>
    <message>
        <source>Projects, drawings, meshes and pictures (%1)</source>
        <translation>프로젝트, 드로잉, 메쉬 및 이미지 (%1)</translation>
    </message>
    <message>
        <source>"%1" doesn't fit into this machine's memory</source>
        <translation>"%1"이(가) 너무 커서 이 컴퓨터의 메모리에 담을 수 없습니다</translation>
    </message>
    <message>
        <source>%1 can't be opened. What was open before is still there.</source>
        <translation>%1을(를) 열 수 없습니다. 이전에 열려 있던 내용은 그대로 있습니다.</translation>
    </message>
    <message>
        <source>%1 is damaged, and what is named below is lost. The file stays as it is: saving asks for another name.</source>
        <translation>%1이(가) 손상되어 아래에 나온 내용을 잃었습니다. 파일은 그대로 두며, 저장할 때 다른 이름을 묻습니다.</translation>
    </message>
    <message>
        <source>Earlier versions, as they were saved:</source>
        <translation>저장된 그대로의 이전 버전:</translation>
    </message>
    <message>
        <source>Open %1, of %2</source>
        <translation>%1 열기 (%2)</translation>
    </message>
    <message>
        <source>No earlier versions lie beside it.</source>
        <translation>같은 위치에 이전 버전이 없습니다.</translation>
    </message>
    <message>
        <source>Croquis</source>
        <translation>Croquis</translation>
    </message>
    <message>
        <source>%1 pictures</source>
        <translation>이미지 %1개</translation>
    </message>
    <message>
        <source>Trace the lines of %1 as strokes, or put it behind the drawing?</source>
        <translation>%1의 선을 획으로 추출할까요, 아니면 드로잉 뒤에 놓을까요?</translation>
    </message>
    <message>
        <source>Trace lines</source>
        <translation>선 추출</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>배경으로 놓기</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>닫힘</translation>
    </message>
    <message>
        <source>open</source>
        <translation>열림</translation>
    </message>
    <message>
        <source>%1 rescued.croq</source>
        <translation>%1 복구본.croq</translation>
    </message>
    <message>
        <source>Your work is not being backed up: %1.</source>
        <translation>작업이 백업되지 않고 있습니다: %1.</translation>
    </message>
    <message>
        <source>Keep proportions</source>
        <translation>비율 유지</translation>
    </message>
    <message>
        <source>Where the middle of its box is: x, y, z</source>
        <translation>경계 상자의 중심 위치: x, y, z</translation>
    </message>
    <message>
        <source>Degrees about x, then y, then z, around its middle</source>
        <translation>중심을 기준으로 x, y, z 순서로 회전한 각도(도)</translation>
    </message>
    <message>
        <source>How far it reaches along its own x, y and z</source>
        <translation>자체 x, y, z 축 방향의 크기</translation>
    </message>
    <message>
        <source>A size along one axis changes the others by the same factor</source>
        <translation>한 축의 크기를 바꾸면 다른 축도 같은 비율로 바뀝니다</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Position, %1</source>
        <translation>위치, %1</translation>
    </message>
    <message>
        <source>Rotation, °</source>
        <translation>회전, °</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>크기</translation>
    </message>
    <message>
        <source>Size, %1</source>
        <translation>크기, %1</translation>
    </message>
    <message>
        <source>The edits can't be read</source>
        <translation>편집 내용을 읽을 수 없습니다</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>고급</translation>
    </message>
    <message>
        <source>Shows everything that can be set</source>
        <translation>설정할 수 있는 모든 항목을 표시합니다</translation>
    </message>
    <message>
        <source>waits for %1</source>
        <translation>%1 대기 중</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>계산 중 …</translation>
    </message>
    <message>
        <source>failed, shows its last result</source>
        <translation>실패, 마지막 결과 표시 중</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>실패</translation>
    </message>
    <message>
        <source>needs attention</source>
        <translation>확인 필요</translation>
    </message>
    <message>
        <source>off</source>
        <translation>꺼짐</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>검사 결과</translation>
    </message>
    <message>
        <source>History</source>
        <translation>작업 내역</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>시작</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>오브젝트</translation>
    </message>
    <message>
        <source>%1 objects</source>
        <translation>오브젝트 %1개</translation>
    </message>
    <message>
        <source>A group: its objects are selected and moved together · Ctrl+Shift+G ungroups</source>
        <translation>그룹: 오브젝트가 함께 선택되고 이동합니다 · Ctrl+Shift+G: 그룹 해제</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>페이스 %1개</translation>
    </message>
    <message>
        <source>Click the eye to hide or show, double click to rename</source>
        <translation>눈 아이콘을 클릭하면 숨기거나 표시하고, 더블 클릭하면 이름을 바꿉니다</translation>
    </message>
    <message>
        <source>A step: click shows its numbers, the right button what can be done</source>
        <translation>단계: 클릭하면 값이, 오른쪽 버튼을 누르면 가능한 작업이 표시됩니다</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>스케치</translation>
    </message>
    <message>
        <source>Start from a sketch</source>
        <translation>스케치로 시작</translation>
    </message>
    <message>
        <source>Start from a cage with sharp edges</source>
        <translation>날카로운 에지가 있는 케이지로 시작</translation>
    </message>
    <message>
        <source>Start from a network of curves</source>
        <translation>커브 네트워크로 시작</translation>
    </message>
    <message>
        <source>Start from a scan with holes</source>
        <translation>구멍이 있는 스캔으로 시작</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>뒤로</translation>
    </message>
    <message>
        <source>New sketch</source>
        <translation>새 스케치</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>열기…</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>%1(으)로 돌아가기</translation>
    </message>
    <message>
        <source>Goes on with what is open (Escape)</source>
        <translation>열려 있는 작업을 계속합니다 (Esc)</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>최근</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>저장되지 않은 작업</translation>
    </message>
    <message>
        <source>Discard all %1</source>
        <translation>%1개 모두 버리기</translation>
    </message>
    <message>
        <source>Untitled sketch</source>
        <translation>제목 없는 스케치</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>복구</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>버리기</translation>
    </message>
    <message>
        <source>Picture behind the drawing</source>
        <translation>드로잉 뒤의 밑그림 이미지</translation>
    </message>
    <message>
        <source>Open a picture…</source>
        <translation>이미지 열기…</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>바꾸기…</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>표시</translation>
    </message>
    <message>
        <source>Show picture</source>
        <translation>밑그림 이미지 표시</translation>
    </message>
    <message>
        <source>Fit to the sheet or the strokes</source>
        <translation>용지 또는 획에 맞추기</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>맞추기</translation>
    </message>
    <message>
        <source>Move and scale</source>
        <translation>이동 및 크기 조절</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>제거</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>밑그림 이미지</translation>
    </message>
    <message>
        <source>Place picture</source>
        <translation>밑그림 이미지 배치</translation>
    </message>
    <message>
        <source>Middle x, y</source>
        <translation>중심 x, y</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>스케일</translation>
    </message>
    <message>
        <source>At 100 % a pixel of the picture is one unit of the drawing</source>
        <translation>100 %에서는 이미지의 픽셀 하나가 드로잉의 한 단위입니다</translation>
    </message>
    <message>
        <source>How strongly the picture is seen behind the drawing</source>
        <translation>드로잉 뒤에서 밑그림 이미지가 보이는 정도</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>불투명도</translation>
    </message>
    <message>
        <source>Open a picture</source>
        <translation>이미지 열기</translation>
    </message>
    <message>
        <source>Drag the picture to move it, a corner to scale it · D draws · Q selects</source>
        <translation>이미지를 드래그하면 이동, 모서리를 드래그하면 크기 조절 · D: 그리기 · Q: 선택</translation>
    </message>
    <message>
        <source>No hole is selected: click one in the list or in a view</source>
        <translation>선택된 구멍이 없습니다. 목록이나 뷰에서 구멍을 클릭하세요</translation>
    </message>
    <message>
        <source>Fill selected</source>
        <translation>선택한 구멍 메우기</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Reopen selected</source>
        <translation>선택한 구멍 다시 열기</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Bridge selected rims</source>
        <translation>선택한 구멍 가장자리 브리지</translation>
    </message>
    <message>
        <source>Fill all inner</source>
        <translation>내부 모두 메우기</translation>
    </message>
    <message>
        <source>Fill all but the largest</source>
        <translation>가장 큰 구멍만 빼고 모두 메우기</translation>
    </message>
    <message>
        <source>Fill all, borders too</source>
        <translation>경계까지 모두 메우기</translation>
    </message>
    <message>
        <source>Reopen all</source>
        <translation>모두 다시 열기</translation>
    </message>
    <message>
        <source>Clear handles of patches</source>
        <translation>패치 핸들 지우기</translation>
    </message>
    <message>
        <source>Method: automatic</source>
        <translation>방법: 자동</translation>
    </message>
    <message>
        <source>Method: continue the surface</source>
        <translation>방법: 서피스 이어 가기</translation>
    </message>
    <message>
        <source>Method: continue its slope</source>
        <translation>방법: 기울기 이어 가기</translation>
    </message>
    <message>
        <source>Method: flat</source>
        <translation>방법: 평평하게</translation>
    </message>
    <message>
        <source>Select two rims to bridge: click one, then Shift+click the other</source>
        <translation>브리지할 구멍 가장자리 두 개를 선택하세요. 하나를 클릭한 다음 다른 하나를 Shift+클릭합니다</translation>
    </message>
    <message>
        <source>O looks for the holes of this mesh</source>
        <translation>O를 누르면 이 메쉬의 구멍을 찾습니다</translation>
    </message>
    <message>
        <source>The patch goes through here · Shift moves it in and out · Escape gives it up</source>
        <translation>패치가 이곳을 지나갑니다 · Shift: 안팎으로 이동 · Esc: 취소</translation>
    </message>
    <message>
        <source>This mesh has no holes</source>
        <translation>이 메쉬에는 구멍이 없습니다</translation>
    </message>
    <message>
        <source>Looking for holes …</source>
        <translation>구멍 찾는 중 …</translation>
    </message>
    <message>
        <source>Click a hole to see its patch, double click to fill it · drag a box · Shift+F fills all inner ones</source>
        <translation>구멍을 클릭하면 패치 미리 보기, 더블 클릭하면 메우기 · 드래그: 박스 선택 · Shift+F: 내부 구멍 모두 메우기</translation>
    </message>
    <message>
        <source>Enter fills what is previewed · drag the patch to shape it · F frames · Shift adds, Ctrl takes away</source>
        <translation>Enter: 미리 보기대로 메우기 · 패치 드래그: 형태 조절 · F: 맞춰 보기 · Shift: 추가, Ctrl: 제외</translation>
    </message>
    <message>
        <source>No method gave a valid patch here: try another method, a bulge or trimming · Delete leaves it open</source>
        <translation>여기서는 어떤 방법으로도 유효한 패치를 만들지 못했습니다. 다른 방법, 볼록함, 다듬기를 시도하세요 · Delete: 열어 두기</translation>
    </message>
    <message>
        <source>Delete opens it again · drag the patch to shape it · F frames · Ctrl+Z undoes</source>
        <translation>Delete: 다시 열기 · 패치 드래그: 형태 조절 · F: 맞춰 보기 · Ctrl+Z: 실행 취소</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>신뢰도</translation>
    </message>
    <message>
        <source>Colours of patches by confidence</source>
        <translation>신뢰도에 따른 패치 색상</translation>
    </message>
    <message>
        <source>1 face</source>
        <translation>페이스 1개</translation>
    </message>
    <message>
        <source>Click to select these faces; F frames them</source>
        <translation>클릭하면 이 페이스를 선택합니다. F: 맞춰 보기</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>구멍 메우기</translation>
    </message>
    <message>
        <source>Holes of a scan: list, preview, fill (O)</source>
        <translation>스캔의 구멍: 목록, 미리 보기, 메우기 (O)</translation>
    </message>
    <message>
        <source>Patches by confidence</source>
        <translation>신뢰도별 패치 색상</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>구멍</translation>
    </message>
    <message>
        <source>O goes back to its holes: there patches are dragged · F9 vertices, F10 edges, F11 faces of the scan</source>
        <translation>O: 구멍으로 돌아가 패치 드래그 · F9 정점, F10 에지, F11 페이스 (스캔)</translation>
    </message>
    <message>
        <source>Numbers of holes</source>
        <translation>구멍 번호</translation>
    </message>
    <message>
        <source>a second</source>
        <translation>1초</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1분</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>Fill %1 up to %2</source>
        <translation>%2 이하 %1개 메우기</translation>
    </message>
    <message>
        <source>About %1, and %2 of memory at most; every vertex of the model will be another one.</source>
        <translation>약 %1, 메모리는 최대 %2. 모델의 모든 정점이 새 정점으로 바뀝니다.</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>검사 중 …</translation>
    </message>
    <message>
        <source>No mesh is being worked on</source>
        <translation>작업 중인 메쉬가 없습니다</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>메우기</translation>
    </message>
    <message>
        <source>Reopen</source>
        <translation>다시 열기</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>브리지</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>맞춰 보기</translation>
    </message>
    <message>
        <source>All but largest</source>
        <translation>가장 큰 것 빼고 모두</translation>
    </message>
    <message>
        <source>There is no hole inside a border</source>
        <translation>경계 안쪽에 구멍이 없습니다</translation>
    </message>
    <message>
        <source>Drag the slider first: it sets the largest diameter</source>
        <translation>먼저 슬라이더를 드래그하여 최대 지름을 정하세요</translation>
    </message>
    <message>
        <source>No hole that small is open</source>
        <translation>그렇게 작은 열린 구멍은 없습니다</translation>
    </message>
    <message>
        <source>Fills the open inner holes with a diameter of at most %1; filled holes stay filled</source>
        <translation>지름이 %1 이하인 열린 내부 구멍을 메웁니다. 이미 메운 구멍은 그대로 둡니다</translation>
    </message>
    <message>
        <source>Fill up to size</source>
        <translation>크기 이하 메우기</translation>
    </message>
    <message>
        <source>Preset, of all holes:</source>
        <translation>모든 구멍의 프리셋:</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>자동</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>표준</translation>
    </message>
    <message>
        <source>Sharp: machined parts</source>
        <translation>날카로움: 기계 가공 부품</translation>
    </message>
    <message>
        <source>Noisy: rough scans</source>
        <translation>노이즈: 거친 스캔</translation>
    </message>
    <message>
        <source>Paper: as Yoo 2005 has it</source>
        <translation>논문: Yoo 2005 방식</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>프리셋</translation>
    </message>
    <message>
        <source>Patches of all holes:</source>
        <translation>모든 구멍의 패치:</translation>
    </message>
    <message>
        <source>Patch of hole %1:</source>
        <translation>구멍 %1의 패치:</translation>
    </message>
    <message>
        <source>Patches of holes %1:</source>
        <translation>구멍 %1의 패치:</translation>
    </message>
    <message>
        <source>Continue the surface</source>
        <translation>서피스 이어 가기</translation>
    </message>
    <message>
        <source>Continue its slope</source>
        <translation>기울기 이어 가기</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>평평하게</translation>
    </message>
    <message>
        <source>Automatic: flat where an open surface ends, elsewhere the surface is continued</source>
        <translation>자동: 열린 서피스가 끝나는 곳은 평평하게, 나머지는 서피스를 이어 갑니다</translation>
    </message>
    <message>
        <source>Of the functions that continue the surface</source>
        <translation>서피스를 이어 가는 함수의 종류</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>방법</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>함수</translation>
    </message>
    <message>
        <source>Bulge</source>
        <translation>볼록함</translation>
    </message>
    <message>
        <source>Turns the slope at the rim: out above 0, in below</source>
        <translation>구멍 가장자리의 기울기를 돌립니다. 0보다 크면 바깥쪽, 작으면 안쪽입니다</translation>
    </message>
    <message>
        <source>Rings of faces taken off the rim</source>
        <translation>구멍 가장자리에서 제거할 페이스 링 수</translation>
    </message>
    <message>
        <source>Rings of faces taken off the rim before it is filled: frayed borders of scans</source>
        <translation>메우기 전에 구멍 가장자리에서 제거할 페이스 링 수: 스캔의 너덜너덜한 경계용</translation>
    </message>
    <message>
        <source>Trim </source>
        <translation>다듬기 </translation>
    </message>
    <message>
        <source> rings</source>
        <translation> 링</translation>
    </message>
    <message>
        <source>Remesh the whole model</source>
        <translation>모델 전체 리메쉬</translation>
    </message>
    <message>
        <source>Patches, rest unchanged</source>
        <translation>패치만 추가, 나머지 유지</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>모드</translation>
    </message>
    <message>
        <source>Clear handles</source>
        <translation>핸들 지우기</translation>
    </message>
    <message>
        <source>Zebra</source>
        <translation>지브라</translation>
    </message>
    <message>
        <source>small</source>
        <translation>작은 구멍</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>구멍</translation>
    </message>
    <message>
        <source>with island</source>
        <translation>섬 있음</translation>
    </message>
    <message>
        <source>tunnel end</source>
        <translation>터널 끝</translation>
    </message>
    <message>
        <source>open edge</source>
        <translation>열린 경계</translation>
    </message>
    <message>
        <source>slit</source>
        <translation>틈</translation>
    </message>
    <message>
        <source>touches another</source>
        <translation>다른 구멍과 맞닿음</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>메움</translation>
    </message>
    <message>
        <source>No holes</source>
        <translation>구멍 없음</translation>
    </message>
    <message>
        <source>%1 filled</source>
        <translation>%1개 메움</translation>
    </message>
    <message>
        <source>%1 open</source>
        <translation>%1개 열림</translation>
    </message>
    <message>
        <source>%1 border left open</source>
        <translation>경계 %1개 열어 둠</translation>
    </message>
    <message>
        <source>%1 borders left open</source>
        <translation>경계 %1개 열어 둠</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1개 실패</translation>
    </message>
    <message>
        <source>1 hole: </source>
        <translation>구멍 1개: </translation>
    </message>
    <message>
        <source>%1 holes: </source>
        <translation>구멍 %1개: </translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 외 %2개</translation>
    </message>
    <message>
        <source>Hole %1: %2 edges, %3 round</source>
        <translation>구멍 %1: 에지 %2개, 둘레 %3</translation>
    </message>
    <message>
        <source>Filled together with %1</source>
        <translation>함께 메운 구멍: %1</translation>
    </message>
    <message>
        <source>Greatest width of holes to fill</source>
        <translation>메울 구멍의 최대 너비</translation>
    </message>
    <message>
        <source>Drag: open holes up to this diameter are selected and previewed</source>
        <translation>드래그: 이 지름 이하의 열린 구멍을 선택하고 미리 봅니다</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>번호</translation>
    </message>
    <message>
        <source>State</source>
        <translation>상태</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>유형</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>에지</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>각도</translation>
    </message>
    <message>
        <source>Number, as pins in the views and the command line have it</source>
        <translation>번호 (뷰의 핀과 명령줄에 쓰이는 번호)</translation>
    </message>
    <message>
        <source>Open, filled, or no method gave a valid patch</source>
        <translation>열림, 메움, 또는 유효한 패치를 만든 방법이 없음</translation>
    </message>
    <message>
        <source>What the rim looks like</source>
        <translation>구멍 가장자리의 형태</translation>
    </message>
    <message>
        <source>Greatest distance between two places of the rim, in the model's own units</source>
        <translation>구멍 가장자리의 두 지점 사이 최대 거리 (모델 자체 단위)</translation>
    </message>
    <message>
        <source>Edges of the rim</source>
        <translation>구멍 가장자리의 에지</translation>
    </message>
    <message>
        <source>Confidence: near 100 % for small gaps, low where the middle is far from anything known</source>
        <translation>신뢰도: 작은 틈은 100 %에 가깝고, 가운데가 알려진 부분에서 멀면 낮음</translation>
    </message>
    <message>
        <source>Greatest angle between patch and scan at the rim</source>
        <translation>구멍 가장자리에서 패치와 스캔 사이의 최대 각도</translation>
    </message>
    <message>
        <source>How the patch was made</source>
        <translation>패치를 만든 방법</translation>
    </message>
    <message>
        <source>Area of the flattest patch</source>
        <translation>가장 평평한 패치의 면적</translation>
    </message>
    <message>
        <source>units</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>Diameter (%1)</source>
        <translation>지름 (%1)</translation>
    </message>
    <message>
        <source>Area (%1)</source>
        <translation>면적 (%1)</translation>
    </message>
    <message>
        <source>%1 edge</source>
        <translation>에지 %1개</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>에지 %1개</translation>
    </message>
    <message>
        <source>closed but for seams (%1): merge the vertices of the scan</source>
        <translation>심(%1)을 제외하고 닫힘: 스캔의 정점을 병합하세요</translation>
    </message>
    <message>
        <source>%1 open edge</source>
        <translation>열린 에지 %1개</translation>
    </message>
    <message>
        <source>%1 open edges</source>
        <translation>열린 에지 %1개</translation>
    </message>
    <message>
        <source>its outer border</source>
        <translation>바깥 경계</translation>
    </message>
    <message>
        <source>its %1 borders</source>
        <translation>경계 %1개</translation>
    </message>
    <message>
        <source>%1 hole</source>
        <translation>구멍 %1개</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>구멍 %1개</translation>
    </message>
    <message>
        <source>open at %1</source>
        <translation>열린 곳: %1</translation>
    </message>
    <message>
        <source> and </source>
        <translation> 및 </translation>
    </message>
    <message>
        <source> and along %1 more</source>
        <translation> 및 그 밖의 %1</translation>
    </message>
    <message>
        <source>manifold</source>
        <translation>매니폴드</translation>
    </message>
    <message>
        <source>%1 non-manifold edge</source>
        <translation>비매니폴드 에지 %1개</translation>
    </message>
    <message>
        <source>%1 non-manifold edges</source>
        <translation>비매니폴드 에지 %1개</translation>
    </message>
    <message>
        <source>%1 new intersection</source>
        <translation>새 교차 %1개</translation>
    </message>
    <message>
        <source>%1 new intersections</source>
        <translation>새 교차 %1개</translation>
    </message>
    <message>
        <source>%1 intersection</source>
        <translation>교차 %1개</translation>
    </message>
    <message>
        <source>%1 intersections</source>
        <translation>교차 %1개</translation>
    </message>
    <message>
        <source>remeshed</source>
        <translation>리메쉬됨</translation>
    </message>
    <message>
        <source>outside unchanged</source>
        <translation>바깥쪽 변경 없음</translation>
    </message>
    <message>
        <source>rims trimmed, else unchanged</source>
        <translation>구멍 가장자리 다듬음, 나머지 변경 없음</translation>
    </message>
    <message>
        <source>outside CHANGED</source>
        <translation>바깥쪽 변경됨!</translation>
    </message>
    <message>
        <source>, otherwise sound: </source>
        <translation>, 그 외 정상: </translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>측정</translation>
    </message>
    <message>
        <source>Copy measurement</source>
        <translation>측정값 복사</translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation>복사됨: %1</translation>
    </message>
    <message>
        <source>Click a place of the model: the nearest vertex, or the surface · Q goes back to selecting</source>
        <translation>모델의 한 지점을 클릭하세요: 가장 가까운 정점 또는 서피스 · Q: 선택으로 돌아가기</translation>
    </message>
    <message>
        <source>Click a second place for the distance · drag a place to move it · Escape starts again</source>
        <translation>두 번째 지점을 클릭하면 거리 측정 · 지점 드래그: 이동 · Esc: 처음부터 다시</translation>
    </message>
    <message>
        <source>Click a third place for angle and radius · Ctrl+C copies · Escape starts again</source>
        <translation>세 번째 지점을 클릭하면 각도와 반지름 측정 · Ctrl+C: 복사 · Esc: 처음부터 다시</translation>
    </message>
    <message>
        <source>Ctrl+C copies what was measured · drag a place to move it · Escape starts again</source>
        <translation>Ctrl+C: 측정값 복사 · 지점 드래그: 이동 · Esc: 처음부터 다시</translation>
    </message>
    <message>
        <source>Selection to vertices</source>
        <translation>선택을 정점으로 변환</translation>
    </message>
    <message>
        <source>Selection to edges</source>
        <translation>선택을 에지로 변환</translation>
    </message>
    <message>
        <source>Selection to faces</source>
        <translation>선택을 페이스로 변환</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>선택 확장</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>선택 축소</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>선택 반전</translation>
    </message>
    <message>
        <source>Edge loop</source>
        <translation>에지 루프</translation>
    </message>
    <message>
        <source>Edge ring</source>
        <translation>에지 링</translation>
    </message>
    <message>
        <source>Shortest path between two</source>
        <translation>둘 사이의 최단 경로</translation>
    </message>
    <message>
        <source>All that is connected</source>
        <translation>연결된 모든 요소</translation>
    </message>
    <message>
        <source>Chain of sharp edges</source>
        <translation>날카로운 에지 체인</translation>
    </message>
    <message>
        <source>All sharp edges</source>
        <translation>모든 날카로운 에지</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>경계</translation>
    </message>
    <message>
        <source>Sharp</source>
        <translation>날카롭게</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>스무스</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>고정</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>고정 해제</translation>
    </message>
    <message>
        <source>Sharp boundary</source>
        <translation>경계를 날카롭게</translation>
    </message>
    <message>
        <source>Sharper by a half</source>
        <translation>0.5만큼 더 날카롭게</translation>
    </message>
    <message>
        <source>Softer by a half</source>
        <translation>0.5만큼 더 부드럽게</translation>
    </message>
    <message>
        <source>Crease set of the selection</source>
        <translation>선택 항목의 크리스 세트</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>Change sharpness</source>
        <translation>날카로움 변경</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>정점</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>페이스</translation>
    </message>
    <message>
        <source>Select through</source>
        <translation>뒤쪽까지 선택</translation>
    </message>
    <message>
        <source>Extrude faces</source>
        <translation>페이스 돌출</translation>
    </message>
    <message>
        <source>Loop cut</source>
        <translation>루프 컷</translation>
    </message>
    <message>
        <source>%1 is %2 times smaller than the rest</source>
        <translation>%1이(가) 나머지보다 %2배 작습니다</translation>
    </message>
    <message>
        <source>%1 is %2 times larger than the rest</source>
        <translation>%1이(가) 나머지보다 %2배 큽니다</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>메쉬</translation>
    </message>
    <message>
        <source>Scale to the scene</source>
        <translation>씬에 맞춰 크기 조절</translation>
    </message>
    <message>
        <source>Gives it the size of everything else; undo takes it back</source>
        <translation>나머지 오브젝트에 맞게 크기를 조절합니다. 실행 취소로 되돌릴 수 있습니다</translation>
    </message>
    <message>
        <source>%1: scale to the scene</source>
        <translation>%1: 씬에 맞춰 크기 조절</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>날카로움</translation>
    </message>
    <message>
        <source>Colours of tagged edges by sharpness</source>
        <translation>날카로움에 따른 태그된 에지의 색상</translation>
    </message>
    <message>
        <source>H makes them sharp, Shift+H smooth · right button: the menu · W moves · Ctrl+Z undoes</source>
        <translation>H: 날카롭게, Shift+H: 매끄럽게 · 오른쪽 버튼: 메뉴 · W: 이동 · Ctrl+Z: 실행 취소</translation>
    </message>
    <message>
        <source>Click an edge, double click its loop · drag a box · Shift adds, Ctrl takes away</source>
        <translation>에지를 클릭, 더블 클릭하면 루프 선택 · 드래그: 박스 선택 · Shift: 추가, Ctrl: 제외</translation>
    </message>
    <message>
        <source>W moves, E rotates, R scales · P pins, Shift+P lets go · Delete dissolves</source>
        <translation>W: 이동, E: 회전, R: 스케일 · P: 고정, Shift+P: 고정 해제 · Delete: 디졸브</translation>
    </message>
    <message>
        <source>Click a vertex or drag a box · Shift adds, Ctrl takes away</source>
        <translation>정점을 클릭하거나 드래그하여 박스 선택 · Shift: 추가, Ctrl: 제외</translation>
    </message>
    <message>
        <source>Shift+E extrudes · W moves, E rotates, R scales · Delete removes</source>
        <translation>Shift+E: 돌출 · W: 이동, E: 회전, R: 스케일 · Delete: 제거</translation>
    </message>
    <message>
        <source>Click a face, double click all that is connected · Shift adds, Ctrl takes away</source>
        <translation>페이스를 클릭, 더블 클릭하면 연결된 모든 페이스 선택 · Shift: 추가, Ctrl: 제외</translation>
    </message>
    <message>
        <source>%1 · Ctrl at the beginning snaps · Escape gives it up</source>
        <translation>%1 · 시작할 때 Ctrl: 스냅 · Esc: 취소</translation>
    </message>
    <message>
        <source>Sharpness %1%2: drag sideways</source>
        <translation>날카로움 %1%2: 좌우로 드래그하세요</translation>
    </message>
    <message>
        <source>Click an edge: the loop is cut there · Escape gives it up</source>
        <translation>에지를 클릭하면 그곳에 루프를 자릅니다 · Esc: 취소</translation>
    </message>
    <message>
        <source>Drag a handle · Ctrl snaps · Shift picks several · Ctrl+D duplicates</source>
        <translation>핸들을 드래그하세요 · Ctrl: 스냅 · Shift: 여러 개 선택 · Ctrl+D: 복제</translation>
    </message>
    <message>
        <source>O finds its holes · 3 makes it smooth · F9 vertices, F10 edges, F11 faces · Alt+drag rotates the view</source>
        <translation>O: 구멍 찾기 · 3: 매끄럽게 · F9 정점, F10 에지, F11 페이스 · Alt+드래그: 뷰 회전</translation>
    </message>
    <message>
        <source>1 vertex</source>
        <translation>정점 1개</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>정점 %1개</translation>
    </message>
    <message>
        <source>1 edge</source>
        <translation>에지 1개</translation>
    </message>
    <message>
        <source>Sharpness of the selected edges in levels: 0 smooth, 10 and more always sharp</source>
        <translation>선택한 에지의 날카로움(레벨 단위): 0은 매끄러움, 10 이상은 항상 날카로움</translation>
    </message>
    <message>
        <source>Least angle of edges to select</source>
        <translation>선택할 에지의 최소 각도</translation>
    </message>
    <message>
        <source>Makes all edges sharp whose faces meet at a greater angle</source>
        <translation>페이스가 이보다 큰 각도로 만나는 모든 에지를 날카롭게 합니다</translation>
    </message>
    <message>
        <source>By angle</source>
        <translation>각도 기준</translation>
    </message>
    <message>
        <source>Drag: edges whose faces meet at a greater angle are selected and counted</source>
        <translation>드래그: 페이스가 이보다 큰 각도로 만나는 에지를 선택하고 개수를 셉니다</translation>
    </message>
    <message>
        <source>Crease sets</source>
        <translation>크리스 세트</translation>
    </message>
    <message>
        <source>New</source>
        <translation>새로 만들기</translation>
    </message>
    <message>
        <source>A set of the selected edges or vertices</source>
        <translation>선택한 에지 또는 정점의 세트</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>선택</translation>
    </message>
    <message>
        <source>Selects the set's edges or vertices</source>
        <translation>세트의 에지 또는 정점을 선택합니다</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>병합</translation>
    </message>
    <message>
        <source>Puts all chosen sets into the first one</source>
        <translation>고른 모든 세트를 첫 번째 세트로 합칩니다</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>삭제</translation>
    </message>
    <message>
        <source>Forgets the set; its edges stay as sharp as they are</source>
        <translation>세트를 삭제합니다. 에지의 날카로움은 그대로 유지됩니다</translation>
    </message>
    <message>
        <source>%1 pins</source>
        <translation>고정 정점 %1개</translation>
    </message>
    <message>
        <source>%1 edges, %2</source>
        <translation>에지 %1개, %2</translation>
    </message>
    <message>
        <source>Sharp edges</source>
        <translation>날카로운 에지</translation>
    </message>
    <message>
        <source>Last edit</source>
        <translation>마지막 편집</translation>
    </message>
    <message>
        <source>No half is found that a mirror would complete</source>
        <translation>미러로 완성할 절반을 찾지 못했습니다</translation>
    </message>
    <message>
        <source>By where it points</source>
        <translation>향하는 방향에 따라</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>자동</translation>
    </message>
    <message>
        <source>Construction lines</source>
        <translation>보조선</translation>
    </message>
    <message>
        <source>Guides</source>
        <translation>보조선</translation>
    </message>
    <message>
        <source>Hidden edge</source>
        <translation>숨은 에지</translation>
    </message>
    <message>
        <source>Link pieces by a construction line</source>
        <translation>보조선으로 조각 연결</translation>
    </message>
    <message>
        <source>Ends go on smoothly</source>
        <translation>끝을 매끄럽게 잇기</translation>
    </message>
    <message>
        <source>Ends are corners</source>
        <translation>끝을 모서리로</translation>
    </message>
    <message>
        <source>Ends as they are drawn</source>
        <translation>끝을 그린 대로</translation>
    </message>
    <message>
        <source>Sharp edge between faces</source>
        <translation>페이스 사이의 날카로운 에지</translation>
    </message>
    <message>
        <source>Known point: click it and type its coordinates</source>
        <translation>알려진 점: 클릭하고 좌표 입력</translation>
    </message>
    <message>
        <source>Known length of a stroke</source>
        <translation>획의 알려진 길이</translation>
    </message>
    <message>
        <source>Add the face between the selected strokes</source>
        <translation>선택한 획 사이에 페이스 추가</translation>
    </message>
    <message>
        <source>No face between the selected strokes</source>
        <translation>선택한 획 사이에 페이스 없음</translation>
    </message>
    <message>
        <source>Make the first proposed fix</source>
        <translation>첫 번째 수정 제안 적용</translation>
    </message>
    <message>
        <source>Complete by mirror</source>
        <translation>미러로 완성</translation>
    </message>
    <message>
        <source>New perspective drawing</source>
        <translation>새 투시 드로잉</translation>
    </message>
    <message>
        <source>Look through the drawing</source>
        <translation>드로잉 시점으로 보기</translation>
    </message>
    <message>
        <source>Length of %1</source>
        <translation>%1의 길이</translation>
    </message>
    <message>
        <source>, no face yet</source>
        <translation>, 아직 페이스 없음</translation>
    </message>
    <message>
        <source>1 edge lacks a face</source>
        <translation>에지 1개에 페이스가 없습니다</translation>
    </message>
    <message>
        <source>%1 edges lack a face</source>
        <translation>에지 %1개에 페이스가 없습니다</translation>
    </message>
    <message>
        <source>Closed, but one face is bent: a stroke is probably missing</source>
        <translation>닫혔지만 페이스 하나가 휘어 있습니다. 빠진 획이 있는 것 같습니다</translation>
    </message>
    <message>
        <source>Closed, but %1 faces are bent: strokes are probably missing</source>
        <translation>닫혔지만 페이스 %1개가 휘어 있습니다. 빠진 획이 있는 것 같습니다</translation>
    </message>
    <message>
        <source>Closed, but a stroke is missing at a corner</source>
        <translation>닫혔지만 모서리에 획 하나가 빠져 있습니다</translation>
    </message>
    <message>
        <source>Closed, but a face is folded</source>
        <translation>닫혔지만 페이스 하나가 접혀 있습니다</translation>
    </message>
    <message>
        <source>Closed, but one stroke contradicts the others</source>
        <translation>닫혔지만 획 하나가 나머지와 모순됩니다</translation>
    </message>
    <message>
        <source>Closed, but %1 strokes contradict the others</source>
        <translation>닫혔지만 획 %1개가 나머지와 모순됩니다</translation>
    </message>
    <message>
        <source>Closed, but one edge is left out</source>
        <translation>닫혔지만 에지 하나가 빠져 있습니다</translation>
    </message>
    <message>
        <source>Closed, but %1 edges are left out</source>
        <translation>닫혔지만 에지 %1개가 빠져 있습니다</translation>
    </message>
    <message>
        <source>Closed, but nothing ties its parts together</source>
        <translation>닫혔지만 부위들이 서로 연결되어 있지 않습니다</translation>
    </message>
    <message>
        <source>Closed, but other faces fit as well</source>
        <translation>닫혔지만 다른 페이스 구성도 가능합니다</translation>
    </message>
    <message>
        <source>Other faces 1</source>
        <translation>다른 페이스 1</translation>
    </message>
    <message>
        <source>These faces fit as well: the hatched ones instead of the dashed ones</source>
        <translation>이 페이스 구성도 맞습니다: 점선 페이스 대신 빗금 친 페이스</translation>
    </message>
    <message>
        <source>Solid closed, %1 shells</source>
        <translation>솔리드 닫힘, 셸 %1개</translation>
    </message>
    <message>
        <source>Solid closed</source>
        <translation>솔리드 닫힘</translation>
    </message>
    <message>
        <source>Draw two lines along each axis: they take the axis' colour from where they point</source>
        <translation>각 축을 따라 선을 두 개씩 그리세요. 향하는 방향에 따라 축의 색이 정해집니다</translation>
    </message>
    <message>
        <source>Click to see the strokes</source>
        <translation>클릭하면 해당 획이 표시됩니다</translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>수정</translation>
    </message>
    <message>
        <source>Add 1 mirrored stroke (Enter)</source>
        <translation>미러 획 1개 추가 (Enter)</translation>
    </message>
    <message>
        <source>Add %1 mirrored strokes (Enter)</source>
        <translation>미러 획 %1개 추가 (Enter)</translation>
    </message>
    <message>
        <source>Look through</source>
        <translation>드로잉 시점으로 보기</translation>
    </message>
    <message>
        <source>See the solid from the drawing's eye, with the drawing over it (V)</source>
        <translation>드로잉의 시점에서 솔리드를 보고 그 위에 드로잉을 겹쳐 표시합니다 (V)</translation>
    </message>
    <message>
        <source>Click the corner whose coordinates are known · Escape stops</source>
        <translation>좌표를 아는 코너를 클릭하세요 · Esc: 중지</translation>
    </message>
    <message>
        <source>Click the stroke whose length is known · Escape stops</source>
        <translation>길이를 아는 획을 클릭하세요 · Esc: 중지</translation>
    </message>
    <message>
        <source>Type a number, if you like with mm, cm, m or in · Enter takes it · Escape stops</source>
        <translation>숫자를 입력하세요. mm, cm, m, in을 붙일 수 있습니다 · Enter: 적용 · Esc: 중지</translation>
    </message>
    <message>
        <source>Enter adds the mirrored strokes · Escape leaves them out</source>
        <translation>Enter: 미러 획 추가 · Esc: 추가 안 함</translation>
    </message>
    <message>
        <source>Drag an end, a handle or a vanishing point · 1–6 give a group · Shift adds · Delete removes · D draws</source>
        <translation>끝점, 핸들 또는 소실점을 드래그하세요 · 1–6: 그룹 지정 · Shift: 추가 선택 · Delete: 제거 · D: 그리기</translation>
    </message>
    <message>
        <source>Drag over strokes to erase them · D draws</source>
        <translation>획 위를 드래그하여 지우세요 · D: 그리기</translation>
    </message>
    <message>
        <source>Draw lines towards the vanishing points · 1 2 3 choose x y z, 0 by direction · E draws edges</source>
        <translation>소실점을 향해 선을 그리세요 · 1 2 3: x y z 선택, 0: 방향에 따라 · E: 에지 그리기</translation>
    </message>
    <message>
        <source>Draw edges: 1 2 3 along x y z, 4 5 6 in planes, 0 by direction · C draws construction lines · Q selects</source>
        <translation>에지를 그리세요: 1 2 3은 x y z 방향, 4 5 6은 평면 안, 0은 방향에 따라 · C: 보조선 그리기 · Q: 선택</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>투시</translation>
    </message>
    <message>
        <source>Perspective drawing</source>
        <translation>투시 드로잉</translation>
    </message>
    <message>
        <source>A4 landscape</source>
        <translation>A4 가로</translation>
    </message>
    <message>
        <source>A4 portrait</source>
        <translation>A4 세로</translation>
    </message>
    <message>
        <source>No camera yet: draw two lines along each axis</source>
        <translation>아직 카메라가 없습니다. 각 축을 따라 선을 두 개씩 그리세요</translation>
    </message>
    <message>
        <source>%1-point perspective, field of view %2°</source>
        <translation>%1점 투시, 시야각 %2°</translation>
    </message>
    <message>
        <source>Size %1 × %2 × %3 %4</source>
        <translation>크기 %1 × %2 × %3 %4</translation>
    </message>
    <message>
        <source>How far the focal length may be off: one standard deviation</source>
        <translation>초점 거리의 예상 오차: 표준 편차 1배</translation>
    </message>
    <message>
        <source>camera certain within %1 %</source>
        <translation>카메라 오차 %1 % 이내</translation>
    </message>
    <message>
        <source>Vanishing points</source>
        <translation>소실점</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>자동</translation>
    </message>
    <message>
        <source>How many vanishing points aren't at infinity</source>
        <translation>무한대에 있지 않은 소실점의 수</translation>
    </message>
    <message>
        <source>Turn x and y round</source>
        <translation>x와 y 뒤집기</translation>
    </message>
    <message>
        <source>Lets x and y point the other way: a drawing doesn't show which</source>
        <translation>x와 y가 반대 방향을 향하게 합니다. 드로잉만으로는 어느 쪽인지 알 수 없습니다</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>알 수 없음</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>시야각</translation>
    </message>
    <message>
        <source>How strongly the drawing is seen over the solid while you look through it</source>
        <translation>드로잉 시점으로 볼 때 솔리드 위에 드로잉이 보이는 정도</translation>
    </message>
    <message>
        <source>Drawing over the solid</source>
        <translation>솔리드 위 드로잉</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>기타</translation>
    </message>
    <message>
        <source>The shape of the sheet; its longer side stays as it is. Strokes keep their places</source>
        <translation>용지의 모양입니다. 긴 변은 그대로 유지되며 획의 위치도 바뀌지 않습니다</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>용지</translation>
    </message>
    <message>
        <source>Known point</source>
        <translation>좌표를 아는 점</translation>
    </message>
    <message>
        <source>Click a corner of the drawing whose coordinates are known and type them (K)</source>
        <translation>드로잉에서 좌표를 아는 코너를 클릭하고 좌표를 입력하세요 (K)</translation>
    </message>
    <message>
        <source>No point is known</source>
        <translation>좌표를 아는 점이 없습니다</translation>
    </message>
    <message>
        <source>Length: select one stroke</source>
        <translation>길이: 획 하나를 선택하세요</translation>
    </message>
    <message>
        <source>no unit</source>
        <translation>단위 없음</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>인치</translation>
    </message>
    <message>
        <source>Unit of lengths</source>
        <translation>길이 단위</translation>
    </message>
    <message>
        <source>Of all lengths and coordinates; known ones keep their size when it changes</source>
        <translation>모든 길이와 좌표의 단위입니다. 단위를 바꿔도 이미 지정한 값의 실제 크기는 유지됩니다</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>선</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>오차</translation>
    </message>
    <message>
        <source>left</source>
        <translation>왼쪽</translation>
    </message>
    <message>
        <source>right</source>
        <translation>오른쪽</translation>
    </message>
    <message>
        <source>top</source>
        <translation>위쪽</translation>
    </message>
    <message>
        <source>Parallel to %1</source>
        <translation>%1축에 평행</translation>
    </message>
    <message>
        <source>In a plane across %1, on a %2 face</source>
        <translation>%1축에 수직인 평면 안, %2 페이스 위</translation>
    </message>
    <message>
        <source>1 stroke</source>
        <translation>획 1개</translation>
    </message>
    <message>
        <source>%1 strokes</source>
        <translation>획 %1개</translation>
    </message>
    <message>
        <source>Seen from the front</source>
        <translation>정면에서 본 모습</translation>
    </message>
    <message>
        <source>Seen from the top</source>
        <translation>위에서 본 모습</translation>
    </message>
    <message>
        <source>Seen from the side</source>
        <translation>측면에서 본 모습</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>그리기</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>지우기</translation>
    </message>
    <message>
        <source>Select and reshape</source>
        <translation>선택 및 모양 변경</translation>
    </message>
    <message>
        <source>Join limbs</source>
        <translation>팔다리 결합</translation>
    </message>
    <message>
        <source>Drag a square to reshape the line, drag a line to move it, Shift adds · Delete removes · D draws</source>
        <translation>사각형을 드래그하면 선의 모양이 바뀌고, 선을 드래그하면 이동합니다 · Shift: 추가 선택 · Delete: 제거 · D: 그리기</translation>
    </message>
    <message>
        <source>Drag over lines to cut pieces out of them · D draws</source>
        <translation>선 위를 드래그하여 일부를 잘라 내세요 · D: 그리기</translation>
    </message>
    <message>
        <source>Draw a closed outline with the pen or the mouse</source>
        <translation>펜이나 마우스로 닫힌 윤곽선을 그리세요</translation>
    </message>
    <message>
        <source>Draw: a line stops where it passes behind another · the right button draws behind · Q selects · Ctrl+Z undoes</source>
        <translation>그리기: 다른 선 뒤로 지나가는 곳에서 선을 멈추세요 · 오른쪽 버튼: 뒤쪽에 그리기 · Q: 선택 · Ctrl+Z: 실행 취소</translation>
    </message>
    <message>
        <source>Trace me: one closed line becomes a solid</source>
        <translation>따라 그려 보세요: 닫힌 선 하나가 솔리드가 됩니다</translation>
    </message>
    <message>
        <source>Thickness of %1. Drag up or down; click to type it</source>
        <translation>%1의 두께입니다. 위아래로 드래그하거나 클릭하여 입력하세요</translation>
    </message>
    <message>
        <source>Thickness of %1. Drag its front; click to type it</source>
        <translation>%1의 두께입니다. 앞면을 드래그하거나 클릭하여 입력하세요</translation>
    </message>
    <message>
        <source>Body %1</source>
        <translation>몸체 %1</translation>
    </message>
    <message>
        <source>Hidden line</source>
        <translation>숨은 선</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>윤곽선</translation>
    </message>
    <message>
        <source>Part in front</source>
        <translation>앞쪽 부위</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>구멍</translation>
    </message>
    <message>
        <source>Small shape</source>
        <translation>작은 형태</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>디테일</translation>
    </message>
    <message>
        <source>Fur, hatching</source>
        <translation>털, 해칭</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>튜브</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>제외됨</translation>
    </message>
    <message>
        <source>Join %1</source>
        <translation>%1 결합</translation>
    </message>
    <message>
        <source>Rest %1 on each other</source>
        <translation>%1 서로 맞닿게 하기</translation>
    </message>
    <message>
        <source>Keep %1 apart</source>
        <translation>%1 분리 유지</translation>
    </message>
    <message>
        <source>Seam radius %1</source>
        <translation>이음매 반지름 %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 및 %2</translation>
    </message>
    <message>
        <source>Seam of %1</source>
        <translation>%1의 이음매</translation>
    </message>
    <message>
        <source>Apart: %1 keep a gap. Click to rest one on the other</source>
        <translation>분리됨: %1 사이에 간격이 있습니다. 클릭하면 서로 맞닿습니다</translation>
    </message>
    <message>
        <source>Resting: %1 touch. Click to join them</source>
        <translation>맞닿음: %1이(가) 서로 닿아 있습니다. 클릭하면 결합됩니다</translation>
    </message>
    <message>
        <source>%1 couldn't be joined, see Findings. Click to keep them apart</source>
        <translation>%1을(를) 결합할 수 없습니다. 검사 결과를 확인하세요. 클릭하면 분리 상태로 유지됩니다</translation>
    </message>
    <message>
        <source>Joined: %1 are one body, seam radius %2. Click to keep them apart; drag, or right click, for the radius</source>
        <translation>결합됨: %1이(가) 한 몸체이며 이음매 반지름은 %2입니다. 클릭하면 분리되고, 드래그하거나 오른쪽 클릭하면 반지름을 바꿀 수 있습니다</translation>
    </message>
    <message>
        <source>Hole in %1. Click to make it a part in front</source>
        <translation>%1의 구멍입니다. 클릭하면 앞쪽 부위가 됩니다</translation>
    </message>
    <message>
        <source>Part in front of %1. Click to make it a hole</source>
        <translation>%1의 앞쪽 부위입니다. 클릭하면 구멍이 됩니다</translation>
    </message>
    <message>
        <source>(read from the drawing)</source>
        <translation>(드로잉에서 인식함)</translation>
    </message>
    <message>
        <source>In front: %1. Behind: %2. Click to swap them</source>
        <translation>앞: %1. 뒤: %2. 클릭하면 서로 바뀝니다</translation>
    </message>
    <message>
        <source>%1: %2. Click (with Q) to make it something else</source>
        <translation>%1: %2. (Q 모드에서) 클릭하면 다른 종류로 바꿀 수 있습니다</translation>
    </message>
    <message>
        <source>As read from the drawing</source>
        <translation>드로잉에서 인식한 대로</translation>
    </message>
    <message>
        <source>Join all parts</source>
        <translation>모든 부위 결합</translation>
    </message>
    <message>
        <source>Chains of sharp edges</source>
        <translation>날카로운 에지 체인</translation>
    </message>
    <message>
        <source>Angles at which the surface folds along the chain, on the level that is seen</source>
        <translation>현재 표시된 레벨에서 체인을 따라 서피스가 꺾이는 각도</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>체인</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>닫힘</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>최소</translation>
    </message>
    <message>
        <source>Greatest</source>
        <translation>최대</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>예</translation>
    </message>
    <message>
        <source>no</source>
        <translation>아니요</translation>
    </message>
    <message>
        <source>1 crease</source>
        <translation>크리스 1개</translation>
    </message>
    <message>
        <source>%1 creases</source>
        <translation>크리스 %1개</translation>
    </message>
    <message>
        <source>1 pin</source>
        <translation>고정 1개</translation>
    </message>
    <message>
        <source>Subdivision</source>
        <translation>서브디비전</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>케이지</translation>
    </message>
    <message>
        <source>Cage and smooth surface</source>
        <translation>케이지와 스무스 서피스</translation>
    </message>
    <message>
        <source>Smooth surface</source>
        <translation>스무스 서피스</translation>
    </message>
    <message>
        <source>Finer</source>
        <translation>더 세밀하게</translation>
    </message>
    <message>
        <source>Coarser</source>
        <translation>더 거칠게</translation>
    </message>
    <message>
        <source>Scheme</source>
        <translation>세분화 방식</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>비교 대상</translation>
    </message>
    <message>
        <source>Side by side with another scheme</source>
        <translation>다른 방식과 나란히 보기</translation>
    </message>
    <message>
        <source>Keep the shape of the selected faces</source>
        <translation>선택한 페이스의 모양 유지</translation>
    </message>
    <message>
        <source>Keep their outline</source>
        <translation>윤곽선 유지</translation>
    </message>
    <message>
        <source>Mesh from what is shown</source>
        <translation>표시된 형태로 메쉬 만들기</translation>
    </message>
    <message>
        <source>1 cage, 2 both, 3 smooth · Page Up and Down change the level · F10 picks edges to sharpen</source>
        <translation>1: 케이지, 2: 둘 다, 3: 스무스 · Page Up/Page Down: 레벨 변경 · F10: 날카롭게 할 에지 선택</translation>
    </message>
    <message>
        <source>Select a patch or a point to see its domain</source>
        <translation>패치나 점을 선택하면 도메인이 표시됩니다</translation>
    </message>
    <message>
        <source>by lengths</source>
        <translation>길이 기준</translation>
    </message>
    <message>
        <source>uniform</source>
        <translation>균일</translation>
    </message>
    <message>
        <source>No patch yet</source>
        <translation>아직 패치 없음</translation>
    </message>
    <message>
        <source>Patch %1</source>
        <translation>패치 %1</translation>
    </message>
    <message>
        <source>Stretch %1×</source>
        <translation>늘어남 %1×</translation>
    </message>
    <message>
        <source> (uniform %1×)</source>
        <translation> (균일 %1×)</translation>
    </message>
    <message>
        <source>Dent of %1: off by %2 (uniform %3), %4 times as long as wide (uniform %5)</source>
        <translation>%1의 함몰: 어긋남 %2 (균일 %3), 길이가 너비의 %4배 (균일 %5)</translation>
    </message>
    <message>
        <source>Mirror across %1 = 0</source>
        <translation>%1 = 0 기준 미러</translation>
    </message>
    <message>
        <source>Patch of the selected curves, or of the closed loop</source>
        <translation>선택한 커브 또는 닫힌 루프로 패치 만들기</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>패치</translation>
    </message>
    <message>
        <source>Smooth, or crease again</source>
        <translation>스무스/크리스 전환</translation>
    </message>
    <message>
        <source>Split the selected curve, or the patch that it divides</source>
        <translation>선택한 커브 또는 커브가 나누는 패치 분할</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>분할</translation>
    </message>
    <message>
        <source>Merge the two patches beside the selected curve</source>
        <translation>선택한 커브 양옆의 두 패치 병합</translation>
    </message>
    <message>
        <source>Turn the selected patches round</source>
        <translation>선택한 패치 뒤집기</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>뒤집기</translation>
    </message>
    <message>
        <source>Slopes along the selected curve automatic</source>
        <translation>선택한 커브의 기울기 자동 설정</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>미러</translation>
    </message>
    <message>
        <source>Symmetric editing</source>
        <translation>대칭 편집</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>대칭</translation>
    </message>
    <message>
        <source>A click inside a loop of curves makes a patch (P)</source>
        <translation>커브 루프 안쪽을 클릭하면 패치가 만들어집니다 (P)</translation>
    </message>
    <message>
        <source>Point on a patch</source>
        <translation>패치 위의 점</translation>
    </message>
    <message>
        <source>A click on a patch and a drag pull it (T)</source>
        <translation>패치를 클릭하고 드래그하면 당겨집니다 (T)</translation>
    </message>
    <message>
        <source>Inner curve</source>
        <translation>내부 커브</translation>
    </message>
    <message>
        <source>A curve drawn on a patch pulls it (I)</source>
        <translation>패치 위에 그린 커브가 패치를 당깁니다 (I)</translation>
    </message>
    <message>
        <source>the ground</source>
        <translation>지면</translation>
    </message>
    <message>
        <source>a plane across the view</source>
        <translation>뷰를 마주 보는 평면</translation>
    </message>
    <message>
        <source>a plane through what is selected</source>
        <translation>선택 항목을 지나는 평면</translation>
    </message>
    <message>
        <source>Draw on</source>
        <translation>그릴 위치</translation>
    </message>
    <message>
        <source>Uniform domain for comparison</source>
        <translation>비교용 균일 도메인</translation>
    </message>
    <message>
        <source>Uniform (U)</source>
        <translation>균일 (U)</translation>
    </message>
    <message>
        <source>Angles along smooth curves</source>
        <translation>스무스 커브의 각도</translation>
    </message>
    <message>
        <source>Surface from</source>
        <translation>다음으로 서피스 만들기</translation>
    </message>
    <message>
        <source>1 curve</source>
        <translation>커브 1개</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>커브 %1개</translation>
    </message>
    <message>
        <source>, no patch yet: P and a click inside a loop makes one</source>
        <translation>, 아직 패치 없음: P를 누르고 루프 안쪽을 클릭하면 만들어집니다</translation>
    </message>
    <message>
        <source>1 patch can't be made: </source>
        <translation>패치 1개를 만들 수 없습니다: </translation>
    </message>
    <message>
        <source>%1 patches can't be made: </source>
        <translation>패치 %1개를 만들 수 없습니다: </translation>
    </message>
    <message>
        <source>1 patch</source>
        <translation>패치 1개</translation>
    </message>
    <message>
        <source>%1 patches</source>
        <translation>패치 %1개</translation>
    </message>
    <message>
        <source>Gap of %1</source>
        <translation>간격 %1</translation>
    </message>
    <message>
        <source>Draw a curve: it lies on the ground, on what is under the pen, or between the curves it meets</source>
        <translation>커브를 그리세요. 지면, 펜 아래에 있는 것, 또는 만나는 커브 사이에 놓입니다</translation>
    </message>
    <message>
        <source>Patch (Enter)</source>
        <translation>패치 (Enter)</translation>
    </message>
    <message>
        <source>The closed loop of curves becomes the border of one smooth patch</source>
        <translation>닫힌 커브 루프가 매끄러운 패치 하나의 경계가 됩니다</translation>
    </message>
    <message>
        <source>Click to see where</source>
        <translation>클릭하면 위치가 표시됩니다</translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>반지름 %1</translation>
    </message>
    <message>
        <source>off by %1, uniform %2</source>
        <translation>어긋남 %1, 균일 %2</translation>
    </message>
    <message>
        <source>There is no patch yet: draw curves that close a loop, then Enter, or P and a click inside it, makes one</source>
        <translation>아직 패치가 없습니다. 루프를 닫는 커브를 그린 다음 Enter를 누르거나, P를 누르고 안쪽을 클릭하면 만들어집니다</translation>
    </message>
    <message>
        <source>Draw on a patch: the surface goes through the curve · Q selects and drags</source>
        <translation>패치 위에 그리세요. 서피스가 커브를 지나갑니다 · Q: 선택 및 드래그</translation>
    </message>
    <message>
        <source>Click inside a loop of curves: it becomes a smooth patch · T puts points on it</source>
        <translation>커브 루프 안쪽을 클릭하면 매끄러운 패치가 됩니다 · T: 패치에 점 추가</translation>
    </message>
    <message>
        <source>Click on a patch and drag: the point pulls it along its normal, with Ctrl across the view</source>
        <translation>패치를 클릭하고 드래그하세요. 점이 패치를 노멀 방향으로 당기며, Ctrl을 누르면 뷰 평면을 따라 당깁니다</translation>
    </message>
    <message>
        <source>Enter makes a patch of the closed loop · go on drawing curves · Q selects</source>
        <translation>Enter: 닫힌 루프로 패치 만들기 · 커브를 계속 그릴 수 있습니다 · Q: 선택</translation>
    </message>
    <message>
        <source>Draw curves from node to node · P fills loops · I draws on a patch · Q selects · Alt+drag rotates</source>
        <translation>노드에서 노드로 커브를 그리세요 · P: 루프 채우기 · I: 패치 위에 그리기 · Q: 선택 · Alt+드래그: 회전</translation>
    </message>
    <message>
        <source>Enter makes a patch of the selected curves · S smooth or crease · Delete</source>
        <translation>Enter: 선택한 커브로 패치 만들기 · S: 스무스/크리스 전환 · Delete: 제거</translation>
    </message>
    <message>
        <source>Drag squares to bend it, blue handles to turn the slope · S smooth or crease · Delete removes</source>
        <translation>사각형을 드래그하면 구부러지고, 파란색 핸들을 드래그하면 기울기가 바뀝니다 · S: 스무스/크리스 전환 · Delete: 제거</translation>
    </message>
    <message>
        <source>Drag the point, or its ring for the radius · U compares with a uniform domain</source>
        <translation>점을 드래그하거나, 고리를 드래그하여 반지름을 바꾸세요 · U: 균일 도메인과 비교</translation>
    </message>
    <message>
        <source>Click or drag a box: curves, nodes, points, patches · Shift adds · D draws · P fills a loop · T points</source>
        <translation>클릭하거나 상자를 드래그하여 커브, 노드, 점, 패치를 선택하세요 · Shift: 추가 선택 · D: 그리기 · P: 루프 채우기 · T: 점</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>점 1개</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>점 %1개</translation>
    </message>
    <message>
        <source>New surface</source>
        <translation>새 서피스</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>서피스</translation>
    </message>
    <message>
        <source>Domain</source>
        <translation>도메인</translation>
    </message>
    <message>
        <source>Begin on a patch: the curve lies on it and pulls it</source>
        <translation>패치 위에서 시작하세요. 커브가 패치 위에 놓여 패치를 당깁니다</translation>
    </message>
    <message>
        <source>Press on a patch: the drag pulls it</source>
        <translation>패치를 누르고 드래그하면 당겨집니다</translation>
    </message>
    <message>
        <source>All patches</source>
        <translation>모든 패치</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>매끄럽게</translation>
    </message>
    <message>
        <source>from positions</source>
        <translation>위치만 사용</translation>
    </message>
    <message>
        <source>as in the paper</source>
        <translation>논문 방식</translation>
    </message>
    <message>
        <source>How a patch is made from its curves: with common tangent planes at smooth curves, from the curves' positions alone, or by the formulas of the paper</source>
        <translation>커브로 패치를 만드는 방법: 스무스 커브에서 접평면 공유, 커브의 위치만 사용, 또는 논문의 공식 사용</translation>
    </message>
    <message>
        <source>How far the middle follows the slopes of the sides: 0 flat, 1 full</source>
        <translation>중앙이 변의 기울기를 따르는 정도: 0은 평평함, 1은 최대</translation>
    </message>
    <message>
        <source>Fullness</source>
        <translation>볼륨감</translation>
    </message>
    <message>
        <source>by the curves' lengths</source>
        <translation>커브 길이 기준</translation>
    </message>
    <message>
        <source>The plane polygon that a patch is a map of</source>
        <translation>패치가 매핑되는 평면 다각형</translation>
    </message>
    <message>
        <source>How strongly the patch leaves the curve</source>
        <translation>패치가 커브에서 뻗어 나가는 강도</translation>
    </message>
    <message>
        <source>Slope of %1</source>
        <translation>%1의 기울기</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>커브</translation>
    </message>
    <message>
        <source>Curve %1</source>
        <translation>커브 %1</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>연결 방식</translation>
    </message>
    <message>
        <source>crease</source>
        <translation>크리스</translation>
    </message>
    <message>
        <source>How the two patches beside a curve meet in it (S)</source>
        <translation>커브 양옆의 두 패치가 커브에서 만나는 방식 (S)</translation>
    </message>
    <message>
        <source>round</source>
        <translation>둥글게</translation>
    </message>
    <message>
        <source>ridge</source>
        <translation>능선형</translation>
    </message>
    <message>
        <source>What the patch does along a curve inside it</source>
        <translation>패치 내부의 커브를 따라 패치가 이루는 형태</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>점</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>점 %1</translation>
    </message>
    <message>
        <source>How far the point pulls: about where the surface is moved half as far as the point</source>
        <translation>점이 당기는 범위: 서피스가 점의 절반 정도 움직이는 거리</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>반지름</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>뾰족하게</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>노멀</translation>
    </message>
    <message>
        <source>The surface's direction at the point is given</source>
        <translation>점에서 서피스의 방향을 지정합니다</translation>
    </message>
    <message>
        <source>Curves are met within %1</source>
        <translation>커브와의 오차 %1 이내</translation>
    </message>
    <message>
        <source>Points are met within %1</source>
        <translation>점과의 오차 %1 이내</translation>
    </message>
    <message>
        <source>Largest angle along smooth curves: %1°</source>
        <translation>스무스 커브의 최대 각도: %1°</translation>
    </message>
    <message>
        <source>Tolerance of ends: %1</source>
        <translation>끝점 허용 오차: %1</translation>
    </message>
    <message>
        <source>Marking menu</source>
        <translation>마킹 메뉴</translation>
    </message>
    <message>
        <source> from %1</source>
        <translation> (원본 %1)</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>외 %1개</translation>
    </message>
    <message>
        <source>Camera of %1</source>
        <translation>%1의 카메라</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>정면</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>윗면</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>측면</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>뷰</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>알 수 없음</translation>
    </message>
    <message>
        <source>. Try croquis --software-gl</source>
        <translation>. croquis --software-gl을 시도해 보세요</translation>
    </message>
    <message>
        <source>Your desktop uses Alt: hold Super, or the key left of 1, and drag to rotate, pan and zoom</source>
        <translation>데스크톱이 Alt 키를 사용 중입니다. Super 키나 1 왼쪽의 키를 누른 채 드래그하여 회전, 화면 이동, 확대/축소하세요</translation>
    </message>
    <message>
        <source>File</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>편집</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>생성</translation>
    </message>
    <message>
        <source>Modify</source>
        <translation>수정</translation>
    </message>
    <message>
        <source>View</source>
        <translation>뷰</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>창</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>도움말</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>도구</translation>
    </message>
    <message>
        <source>Attributes</source>
        <translation>속성</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>최근 파일 열기</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>예제</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>명령 검색</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>무엇을 하시겠습니까?</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>찾은 명령</translation>
    </message>
    <message>
        <source>Not possible with what is selected now</source>
        <translation>현재 선택한 항목으로는 실행할 수 없습니다</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>명령</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>메뉴</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>단축키</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>폴더 열기</translation>
    </message>
    <message>
        <source>Croquis %1</source>
        <translation>Croquis %1</translation>
    </message>
    <message>
        <source>Qt %1, %2, %3</source>
        <translation>Qt %1, %2, %3</translation>
    </message>
    <message>
        <source>Graphics: %1</source>
        <translation>그래픽: %1</translation>
    </message>
    <message>
        <source>Window %1 × %2, scale %3</source>
        <translation>창 %1 × %2, 배율 %3</translation>
    </message>
    <message>
        <source>Objects: %1</source>
        <translation>오브젝트: %1</translation>
    </message>
    <message>
        <source>source</source>
        <translation>원본</translation>
    </message>
    <message>
        <source>- %1: %2 vertices, %3 faces</source>
        <translation>- %1: 정점 %2개, 페이스 %3개</translation>
    </message>
    <message>
        <source>Keys of the present tool</source>
        <translation>현재 도구의 단축키</translation>
    </message>
    <message>
        <source>About Croquis</source>
        <translation>Croquis 정보</translation>
    </message>
    <message>
        <source>Croquis %1

Drawings, curves, cages and scans become solids.

Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Croquis %1

드로잉, 커브, 케이지, 스캔이 솔리드가 됩니다.

GNU General Public License 버전 3 이상에 따른 자유 소프트웨어입니다.</translation>
    </message>
    <message>
        <source>Help for the present tool</source>
        <translation>현재 도구 도움말</translation>
    </message>
    <message>
        <source>Copy diagnostics</source>
        <translation>진단 정보 복사</translation>
    </message>
    <message>
        <source>Version, graphics and what is open were copied: paste them where you ask</source>
        <translation>버전, 그래픽, 열린 항목 정보를 복사했습니다. 문의하는 곳에 붙여 넣으세요</translation>
    </message>
    <message>
        <source>"%1" holds no keys: %2. Choose a file that was exported from the list of keys.</source>
        <translation>"%1"에 단축키가 없습니다: %2. 단축키 목록에서 내보낸 파일을 선택하세요.</translation>
    </message>
    <message>
        <source>"%1" has no list of keys</source>
        <translation>"%1"에 단축키 목록이 없습니다</translation>
    </message>
    <message>
        <source>"%1" of "%2" is no key</source>
        <translation>"%2"의 "%1"은(는) 키가 아닙니다</translation>
    </message>
    <message>
        <source>Maya</source>
        <translation>Maya</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>CAD</source>
        <translation>CAD</translation>
    </message>
    <message>
        <source>there is no preset "%1"</source>
        <translation>"%1" 프리셋이 없습니다</translation>
    </message>
    <message>
        <source>Escape goes back to what was open; or choose a sketch, or press Ctrl+N</source>
        <translation>Esc를 누르면 열려 있던 작업으로 돌아갑니다. 또는 스케치를 선택하거나 Ctrl+N을 누르세요</translation>
    </message>
    <message>
        <source>Choose a sketch, or press Ctrl+N and draw</source>
        <translation>스케치를 선택하거나 Ctrl+N을 누르고 그리세요</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>취소되었습니다.</translation>
    </message>
    <message>
        <source>Alt + left button rotates, Alt + middle pans, Alt + right zooms</source>
        <translation>Alt + 왼쪽 버튼은 회전, Alt + 가운데 버튼은 화면 이동, Alt + 오른쪽 버튼은 확대/축소입니다</translation>
    </message>
    <message>
        <source>The middle button rotates, with Shift pans, with Ctrl zooms</source>
        <translation>가운데 버튼은 회전, Shift와 함께 화면 이동, Ctrl과 함께 확대/축소입니다</translation>
    </message>
    <message>
        <source>The middle button rotates, with Ctrl pans, with Shift zooms</source>
        <translation>가운데 버튼은 회전, Ctrl과 함께 화면 이동, Shift와 함께 확대/축소입니다</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>명령과 단축키</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>새 단축키</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>설정</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>제거</translation>
    </message>
    <message>
        <source>As in the &amp;preset</source>
        <translation>프리셋대로</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>내보내기…</translation>
    </message>
    <message>
        <source>I&amp;mport…</source>
        <translation>가져오기…</translation>
    </message>
    <message>
        <source>Also the key of %1</source>
        <translation>%1의 단축키이기도 합니다</translation>
    </message>
    <message>
        <source>Export keys</source>
        <translation>단축키 내보내기</translation>
    </message>
    <message>
        <source>Keys (*.json)</source>
        <translation>단축키 (*.json)</translation>
    </message>
    <message>
        <source>"%1" can't be written: %2</source>
        <translation>"%1"에 쓸 수 없습니다: %2</translation>
    </message>
    <message>
        <source>Import keys</source>
        <translation>단축키 가져오기</translation>
    </message>
    <message>
        <source>"%1" can't be read: %2</source>
        <translation>"%1"을(를) 읽을 수 없습니다: %2</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>환경 설정</translation>
    </message>
    <message>
        <source>Search commands and keys</source>
        <translation>명령 및 단축키 검색</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>언어</translation>
    </message>
    <message>
        <source>&amp;Navigation as in</source>
        <translation>화면 조작 방식</translation>
    </message>
    <message>
        <source>&amp;Keys as in</source>
        <translation>단축키 방식</translation>
    </message>
    <message>
        <source>Add step</source>
        <translation>단계 추가</translation>
    </message>
    <message>
        <source>Enable step</source>
        <translation>단계 활성화</translation>
    </message>
    <message>
        <source>Move step down</source>
        <translation>단계 아래로 이동</translation>
    </message>
    <message>
        <source>Move step up</source>
        <translation>단계 위로 이동</translation>
    </message>
    <message>
        <source>Duplicate step</source>
        <translation>단계 복제</translation>
    </message>
    <message>
        <source>Freeze step</source>
        <translation>단계 프리즈</translation>
    </message>
    <message>
        <source>Apply to the new mesh by number</source>
        <translation>번호 기준으로 새 메쉬에 적용</translation>
    </message>
    <message>
        <source>Apply to the new mesh</source>
        <translation>새 메쉬에 적용</translation>
    </message>
    <message>
        <source>Delete step</source>
        <translation>단계 삭제</translation>
    </message>
    <message>
        <source>Duplicate object</source>
        <translation>오브젝트 복제</translation>
    </message>
    <message>
        <source>Delete object</source>
        <translation>오브젝트 삭제</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>그룹</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>그룹 해제</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>숨기기</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>모두 표시</translation>
    </message>
    <message>
        <source>Isolate selection</source>
        <translation>선택 항목만 보기</translation>
    </message>
    <message>
        <source>Keep the shape</source>
        <translation>모양 유지</translation>
    </message>
    <message>
        <source>Project (*.croq)</source>
        <translation>프로젝트 (*.croq)</translation>
    </message>
    <message>
        <source>Meshes and pictures (%1)</source>
        <translation>메쉬와 이미지 (%1)</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>가져오기</translation>
    </message>
    <message>
        <source>%1 meshes</source>
        <translation>메쉬 %1개</translation>
    </message>
    <message>
        <source>Open %1 in place of what is open, or add it?</source>
        <translation>현재 열린 내용 대신 %1을(를) 여시겠습니까, 아니면 추가하시겠습니까?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>바꾸기</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>추가</translation>
    </message>
    <message>
        <source>%1 is open in another window of Croquis. Saving here replaces what is saved there.</source>
        <translation>%1이(가) Croquis의 다른 창에 열려 있습니다. 여기서 저장하면 그쪽에 저장된 내용을 덮어씁니다.</translation>
    </message>
    <message>
        <source>%1 was saved by another window or program after it was opened here. Saving here replaces that.</source>
        <translation>여기서 연 뒤에 다른 창이나 프로그램에서 %1을(를) 저장했습니다. 여기서 저장하면 그 내용을 덮어씁니다.</translation>
    </message>
    <message>
        <source>%1 has been saved</source>
        <translation>%1을(를) 저장했습니다</translation>
    </message>
    <message>
        <source>%1; the damaged one is kept as %2</source>
        <translation>%1. 손상된 파일은 %2(으)로 보관했습니다</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>프로젝트 저장</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 저장됨</translation>
    </message>
    <message>
        <source>Looking at the mesh …</source>
        <translation>메쉬 확인 중 …</translation>
    </message>
    <message>
        <source>Export mesh</source>
        <translation>메쉬 내보내기</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>그래도 내보내기</translation>
    </message>
    <message>
        <source>%1 filled.ply</source>
        <translation>%1 메움.ply</translation>
    </message>
    <message>
        <source>Export STEP</source>
        <translation>STEP 내보내기</translation>
    </message>
    <message>
        <source>STEP (*.step *.stp)</source>
        <translation>STEP (*.step *.stp)</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>이미지 내보내기</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>Export drawing</source>
        <translation>드로잉 내보내기</translation>
    </message>
    <message>
        <source>Network of curves (*.json)</source>
        <translation>커브 네트워크 (*.json)</translation>
    </message>
    <message>
        <source>SVG (*.svg)</source>
        <translation>SVG (*.svg)</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 내보내기</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Export mesh…</source>
        <translation>메쉬 내보내기…</translation>
    </message>
    <message>
        <source>The selected objects as one file</source>
        <translation>선택한 오브젝트를 파일 하나로</translation>
    </message>
    <message>
        <source>Export visible…</source>
        <translation>보이는 항목 내보내기…</translation>
    </message>
    <message>
        <source>Export all…</source>
        <translation>모두 내보내기…</translation>
    </message>
    <message>
        <source>Unit of exported meshes</source>
        <translation>내보낼 메쉬의 단위</translation>
    </message>
    <message>
        <source>As in the document</source>
        <translation>문서와 동일</translation>
    </message>
    <message>
        <source>Export STEP…</source>
        <translation>STEP 내보내기…</translation>
    </message>
    <message>
        <source>Export picture…</source>
        <translation>이미지 내보내기…</translation>
    </message>
    <message>
        <source>Export drawing…</source>
        <translation>드로잉 내보내기…</translation>
    </message>
    <message>
        <source>Export %1…</source>
        <translation>%1 내보내기…</translation>
    </message>
    <message>
        <source>Nothing was opened yet</source>
        <translation>아직 연 파일이 없습니다</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>가져오기…</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>시작 페이지</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>저장</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>다른 이름으로 저장…</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>종료</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>제목 없음</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>열기</translation>
    </message>
    <message>
        <source>Save what was made here?</source>
        <translation>여기서 만든 내용을 저장하시겠습니까?</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>%1의 변경 사항을 저장하시겠습니까?</translation>
    </message>
    <message>
        <source> And %1 more: see the panel Findings.</source>
        <translation> 그 밖에 %1개가 더 있습니다. 검사 결과 패널을 확인하세요.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>실행 취소</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>다시 실행</translation>
    </message>
    <message>
        <source>Search commands…</source>
        <translation>명령 검색…</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>환경 설정…</translation>
    </message>
    <message>
        <source>All</source>
        <translation>모두</translation>
    </message>
    <message>
        <source>None</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Frame all</source>
        <translation>모두 맞춰 보기</translation>
    </message>
    <message>
        <source>Frame selection</source>
        <translation>선택 항목 맞춰 보기</translation>
    </message>
    <message>
        <source>Maximise view</source>
        <translation>뷰 최대화</translation>
    </message>
    <message>
        <source>Sketch and perspective</source>
        <translation>스케치와 투시 뷰</translation>
    </message>
    <message>
        <source>Four views</source>
        <translation>4분할 뷰</translation>
    </message>
    <message>
        <source>Perspective alone</source>
        <translation>투시 뷰만</translation>
    </message>
    <message>
        <source>Front alone</source>
        <translation>정면 뷰만</translation>
    </message>
    <message>
        <source>Top alone</source>
        <translation>윗면 뷰만</translation>
    </message>
    <message>
        <source>Side alone</source>
        <translation>옆면 뷰만</translation>
    </message>
    <message>
        <source>Wire</source>
        <translation>와이어프레임</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>셰이딩</translation>
    </message>
    <message>
        <source>Shaded, with wire</source>
        <translation>셰이딩 + 와이어프레임</translation>
    </message>
    <message>
        <source>Flat shading</source>
        <translation>플랫 셰이딩</translation>
    </message>
    <message>
        <source>Zebra stripes</source>
        <translation>지브라 줄무늬</translation>
    </message>
    <message>
        <source>Restore default layout</source>
        <translation>기본 레이아웃 복원</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>솔리드</translation>
    </message>
    <message>
        <source>Turns drawn contours, whose parts may hide each other, into closed solids.</source>
        <translation>그린 윤곽선을 닫힌 솔리드로 만듭니다. 부위가 서로 가려져 있어도 됩니다.</translation>
    </message>
    <message>
        <source>Lines are</source>
        <translation>선의 종류</translation>
    </message>
    <message>
        <source>auto for any lines, clean for exact ones that are refused where they cross, tablet for lines drawn by hand, smoothed.</source>
        <translation>auto는 모든 선, clean은 교차하면 거부되는 정확한 선, tablet은 손으로 그려 매끄럽게 다듬을 선에 사용합니다.</translation>
    </message>
    <message>
        <source>any</source>
        <translation>모든 선</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>정확한 선</translation>
    </message>
    <message>
        <source>drawn by hand</source>
        <translation>손으로 그린 선</translation>
    </message>
    <message>
        <source>Smooth arcs</source>
        <translation>매끄러운 호</translation>
    </message>
    <message>
        <source>How much bending costs: high gives long gentle arcs.</source>
        <translation>휘어짐에 드는 비용입니다. 높으면 길고 완만한 호가 됩니다.</translation>
    </message>
    <message>
        <source>Keep flat</source>
        <translation>평평하게 유지</translation>
    </message>
    <message>
        <source>How much tilting costs: high keeps parts flat.</source>
        <translation>기울어짐에 드는 비용입니다. 높으면 부위가 평평하게 유지됩니다.</translation>
    </message>
    <message>
        <source>Keep near the plane</source>
        <translation>평면 가까이 유지</translation>
    </message>
    <message>
        <source>How much depth costs: high keeps parts near the plane.</source>
        <translation>깊이에 드는 비용입니다. 높으면 부위가 평면 가까이에 유지됩니다.</translation>
    </message>
    <message>
        <source>Gap between parts</source>
        <translation>부위 사이 간격</translation>
    </message>
    <message>
        <source>Least distance between parts in front of one another.</source>
        <translation>앞뒤로 놓인 부위 사이의 최소 거리입니다.</translation>
    </message>
    <message>
        <source>× the parts' median radius</source>
        <translation>× 부위 반지름 중앙값</translation>
    </message>
    <message>
        <source>Smallest detail</source>
        <translation>최소 디테일</translation>
    </message>
    <message>
        <source>Spacing of points along the contours: smaller is finer.</source>
        <translation>윤곽선을 따라 놓이는 점의 간격입니다. 작을수록 세밀합니다.</translation>
    </message>
    <message>
        <source>‰ of the drawing's diagonal</source>
        <translation>‰ (그림 대각선 기준)</translation>
    </message>
    <message>
        <source>Lines on the body</source>
        <translation>몸체 위의 선</translation>
    </message>
    <message>
        <source>What the lines within a body become, such as a mouth or fur: lines on the surface, grooves cut into it, or ridges raised from it.</source>
        <translation>입이나 털처럼 몸체 안에 그린 선을 무엇으로 만들지 정합니다: 표면 위의 선, 표면에 파인 홈, 표면에서 돋은 능선.</translation>
    </message>
    <message>
        <source>drawn on</source>
        <translation>표면에 그리기</translation>
    </message>
    <message>
        <source>cut in</source>
        <translation>파내기</translation>
    </message>
    <message>
        <source>raised</source>
        <translation>돋우기</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>선 너비</translation>
    </message>
    <message>
        <source>How wide grooves and ridges are; they are a quarter as deep.</source>
        <translation>홈과 능선의 너비입니다. 깊이는 너비의 4분의 1입니다.</translation>
    </message>
    <message>
        <source>How parts are joined</source>
        <translation>부위 결합 방식</translation>
    </message>
    <message>
        <source>Objects that are held together where they overlap: auto for all that look it, else pairs: A,B or A,B=K grow together, K from 0 to 1 being the least distance of their middles in parts of that of touching ones, 0.55 unless said, and A,B=K:R with a seam of radius R, 0 to 1; A,B=rest touch, A,B=apart keep a gap.</source>
        <translation>겹치는 곳에서 서로 붙는 오브젝트입니다. auto는 붙어 보이는 모든 오브젝트에 적용되며, 그 외에는 쌍으로 지정합니다: A,B 또는 A,B=K는 하나로 이어지고, K(0~1)는 맞닿은 두 오브젝트의 중심 거리를 기준으로 한 최소 중심 거리 비율이며 지정하지 않으면 0.55입니다. A,B=K:R은 반지름 R(0~1)의 이음매로 이어지고, A,B=rest는 맞닿으며, A,B=apart는 간격을 유지합니다.</translation>
    </message>
    <message>
        <source>Outlines that cross</source>
        <translation>교차하는 윤곽선</translation>
    </message>
    <message>
        <source>Outlines that cross in full view: the closed line drawn later lies in front, or they are refused, as the preset clean does.</source>
        <translation>가려지지 않고 교차하는 윤곽선의 처리입니다. 나중에 그린 닫힌 선을 앞에 놓거나, 프리셋 clean처럼 거부합니다.</translation>
    </message>
    <message>
        <source>front</source>
        <translation>앞에 놓기</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>거부</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>프리셋에 따름</translation>
    </message>
    <message>
        <source>Solid from Perspective</source>
        <translation>투시 드로잉으로 솔리드 만들기</translation>
    </message>
    <message>
        <source>Turns one perspective drawing into a solid: finds the eye, lifts every stroke into space, finds the faces.</source>
        <translation>투시 드로잉 하나를 솔리드로 만듭니다. 시점을 찾고, 모든 획을 공간으로 옮기고, 페이스를 찾습니다.</translation>
    </message>
    <message>
        <source>How many vanishing points aren't at infinity; auto takes the simplest that the lines agree with.</source>
        <translation>무한히 멀지 않은 소실점의 개수입니다. auto는 선과 맞는 가장 단순한 경우를 택합니다.</translation>
    </message>
    <message>
        <source>found</source>
        <translation>자동 감지</translation>
    </message>
    <message>
        <source>Smooth below</source>
        <translation>스무스 최대 각도</translation>
    </message>
    <message>
        <source>Strokes and faces that turn less go on smoothly into each other.</source>
        <translation>이보다 적게 꺾이는 획과 페이스는 서로 매끄럽게 이어집니다.</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>도</translation>
    </message>
    <message>
        <source>Greatest distance of the mesh from the surfaces: smaller is finer.</source>
        <translation>메쉬와 서피스 사이의 최대 거리입니다. 작을수록 세밀합니다.</translation>
    </message>
    <message>
        <source>× the solid's diagonal</source>
        <translation>× 솔리드 대각선</translation>
    </message>
    <message>
        <source>A place of the drawing and its coordinates in space: U,V=X,Y,Z.</source>
        <translation>드로잉의 한 위치와 그 공간 좌표입니다: U,V=X,Y,Z.</translation>
    </message>
    <message>
        <source>The length of a stroke in space: STROKE=LENGTH.</source>
        <translation>공간에서의 획 길이입니다: STROKE=LENGTH.</translation>
    </message>
    <message>
        <source>Across the width of the sheet, where it is known; 0 where it isn't.</source>
        <translation>용지 너비에 걸친 시야각(알고 있는 경우)이며, 모르면 0입니다.</translation>
    </message>
    <message>
        <source>x and y point the other way; a drawing doesn't show which.</source>
        <translation>x와 y가 반대 방향을 향합니다. 드로잉만으로는 어느 쪽인지 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>무시</translation>
    </message>
    <message>
        <source>A stroke that is left out.</source>
        <translation>제외할 획입니다.</translation>
    </message>
    <message>
        <source>Makes the first proposed change of a stroke that contradicts the others.</source>
        <translation>다른 획과 모순되는 획에 대해 첫 번째로 제안된 변경을 적용합니다.</translation>
    </message>
    <message>
        <source>Faces that must be there, each by its strokes: e1+e2+e3.</source>
        <translation>반드시 있어야 하는 페이스입니다. 각각 획으로 지정합니다: e1+e2+e3.</translation>
    </message>
    <message>
        <source>No faces</source>
        <translation>제외할 페이스</translation>
    </message>
    <message>
        <source>Faces that must not be there, each by its strokes: e1+e2+e3.</source>
        <translation>있으면 안 되는 페이스입니다. 각각 획으로 지정합니다: e1+e2+e3.</translation>
    </message>
    <message>
        <source>Strokes along which faces stay sharp.</source>
        <translation>페이스가 날카롭게 만나는 획입니다.</translation>
    </message>
    <message>
        <source>Steps of the search for faces</source>
        <translation>페이스 탐색 단계 수</translation>
    </message>
    <message>
        <source>Steps of the search for faces, for each part of the drawing.</source>
        <translation>드로잉의 부위마다 페이스를 탐색하는 단계 수입니다.</translation>
    </message>
    <message>
        <source>Attribute Network</source>
        <translation>속성 네트워크</translation>
    </message>
    <message>
        <source>Makes an attribute network of a solid: its curves, and a face for each loop of 2 to 12 of them.</source>
        <translation>솔리드의 속성 네트워크를 만듭니다. 솔리드의 커브와, 커브 2~12개로 된 루프마다 페이스 하나가 들어갑니다.</translation>
    </message>
    <message>
        <source>Contours as Curves</source>
        <translation>윤곽선을 커브로</translation>
    </message>
    <message>
        <source>Makes curves of an attribute network of the strokes of a drawing; faces are spanned between them afterwards.</source>
        <translation>드로잉의 획으로 속성 네트워크의 커브를 만듭니다. 페이스는 나중에 커브 사이에 만들어집니다.</translation>
    </message>
    <message>
        <source>Off the strokes by at most</source>
        <translation>획과의 최대 거리</translation>
    </message>
    <message>
        <source>How far curves may be from what was drawn: smaller takes more curves.</source>
        <translation>커브가 그린 선에서 벗어날 수 있는 거리입니다. 작을수록 커브가 많아집니다.</translation>
    </message>
    <message>
        <source>× the drawing's diagonal</source>
        <translation>× 그림 대각선</translation>
    </message>
    <message>
        <source>Ends meet within</source>
        <translation>끝점 연결 거리</translation>
    </message>
    <message>
        <source>Ends of strokes that are so near to each other, or to a stroke, meet.</source>
        <translation>획의 끝점끼리, 또는 끝점과 획이 이 거리 안에 있으면 연결됩니다.</translation>
    </message>
    <message>
        <source>Corner above</source>
        <translation>코너 최소 각도</translation>
    </message>
    <message>
        <source>Strokes that turn more have a corner there; 180 for none.</source>
        <translation>이보다 많이 꺾이는 획은 그곳에 코너가 생깁니다. 180이면 코너가 없습니다.</translation>
    </message>
    <message>
        <source>Edges as Curves</source>
        <translation>에지를 커브로</translation>
    </message>
    <message>
        <source>Makes curves of an attribute network along edges of a mesh; faces are spanned between them afterwards.</source>
        <translation>메쉬의 에지를 따라 속성 네트워크의 커브를 만듭니다. 페이스는 나중에 커브 사이에 만들어집니다.</translation>
    </message>
    <message>
        <source>Edges of one face, or those where faces meet at more than angle.</source>
        <translation>페이스 하나에만 속한 에지, 또는 페이스가 angle보다 큰 각도로 만나는 에지입니다.</translation>
    </message>
    <message>
        <source>of the border</source>
        <translation>경계 에지</translation>
    </message>
    <message>
        <source>sharp ones</source>
        <translation>날카로운 에지</translation>
    </message>
    <message>
        <source>Edges instead, each by its vertices, counted from 0: 3-7,7-12.</source>
        <translation>대신 사용할 에지입니다. 각각 0부터 센 정점 번호로 지정합니다: 3-7,7-12.</translation>
    </message>
    <message>
        <source>Sharp above</source>
        <translation>날카로움 최소 각도</translation>
    </message>
    <message>
        <source>Faces that meet at more have a sharp edge.</source>
        <translation>이보다 큰 각도로 만나는 페이스 사이의 에지는 날카로운 에지가 됩니다.</translation>
    </message>
    <message>
        <source>Off the edges by at most</source>
        <translation>에지와의 최대 거리</translation>
    </message>
    <message>
        <source>How far curves may be from vertices: smaller takes more curves.</source>
        <translation>커브가 정점에서 벗어날 수 있는 거리입니다. 작을수록 커브가 많아집니다.</translation>
    </message>
    <message>
        <source>× the model's diagonal</source>
        <translation>× 모델 대각선</translation>
    </message>
    <message>
        <source>Rows of edges that turn more have a corner there; 180 for none.</source>
        <translation>이보다 많이 꺾이는 에지 줄은 그곳에 코너가 생깁니다. 180이면 코너가 없습니다.</translation>
    </message>
    <message>
        <source>Continue the faces around</source>
        <translation>주변 페이스와 이어지게</translation>
    </message>
    <message>
        <source>Give curves the mesh's normals, so that faces spanned between them continue it smoothly.</source>
        <translation>커브에 메쉬의 노멀을 주어, 커브 사이에 만들어지는 페이스가 메쉬와 매끄럽게 이어지게 합니다.</translation>
    </message>
    <message>
        <source>Subdivision Cage</source>
        <translation>서브디비전 케이지</translation>
    </message>
    <message>
        <source>Makes a cage for subdivision of a solid: quads along its patches, polygons along its planes, sharp edges tagged.</source>
        <translation>솔리드의 서브디비전용 케이지를 만듭니다. 패치에는 사각형, 평면에는 다각형이 놓이고 날카로운 에지에는 태그가 붙습니다.</translation>
    </message>
    <message>
        <source>Edges along a curve</source>
        <translation>커브당 에지 수</translation>
    </message>
    <message>
        <source>Into how many edges a curve is divided, and a straight edge of a curved face.</source>
        <translation>커브 하나, 그리고 곡면 페이스의 직선 에지 하나를 나누는 에지 수입니다.</translation>
    </message>
    <message>
        <source>Attribute Surface</source>
        <translation>속성 서피스</translation>
    </message>
    <message>
        <source>Turns a network of curves into smooth patches of any number of sides, which points and curves inside pull.</source>
        <translation>커브 네트워크를 변의 개수에 제한이 없는 매끄러운 패치로 만듭니다. 안쪽의 점과 커브가 패치를 당깁니다.</translation>
    </message>
    <message>
        <source>Patches are</source>
        <translation>패치 방식</translation>
    </message>
    <message>
        <source>How faces are blended: with common tangent planes at smooth curves, from positions alone, by the paper's formulas, or as the network says of each.</source>
        <translation>페이스를 블렌딩하는 방식입니다: 매끄러운 커브에서 공통 접평면 사용, 위치만 사용, 논문의 공식 사용, 또는 페이스마다 네트워크의 설정을 따릅니다.</translation>
    </message>
    <message>
        <source>each as chosen</source>
        <translation>각각의 설정에 따름</translation>
    </message>
    <message>
        <source>creased</source>
        <translation>크리스</translation>
    </message>
    <message>
        <source>as published in 2006</source>
        <translation>2006년 논문 방식</translation>
    </message>
    <message>
        <source>Sides of patches</source>
        <translation>패치의 변</translation>
    </message>
    <message>
        <source>The polygon that a face is a map of: with its curves' lengths as sides, a regular one, or as the network says of each.</source>
        <translation>페이스가 매핑되는 다각형입니다: 커브 길이를 변으로 하는 다각형, 정다각형, 또는 페이스마다 네트워크의 설정을 따릅니다.</translation>
    </message>
    <message>
        <source>as long as the curves</source>
        <translation>커브 길이대로</translation>
    </message>
    <message>
        <source>all the same</source>
        <translation>모두 같게</translation>
    </message>
    <message>
        <source>How full smooth faces are, -1 to 2: 1 follows the slopes at the sides, 0 is flat; empty: as the network says.</source>
        <translation>매끄러운 페이스가 부푸는 정도(-1~2)입니다. 1은 변의 기울기를 따르고 0은 평평하며, 비워 두면 네트워크의 설정을 따릅니다.</translation>
    </message>
    <message>
        <source>Parts of each curve, and rings of triangles around the middle of each face.</source>
        <translation>각 커브를 나누는 수이자, 각 페이스의 중심을 둘러싸는 삼각형 링의 수입니다.</translation>
    </message>
    <message>
        <source>Off the surface by at most</source>
        <translation>서피스와의 최대 거리</translation>
    </message>
    <message>
        <source>Greatest distance of the mesh from the surface: as few triangles as keep to it; 0: rings of triangles.</source>
        <translation>메쉬와 서피스 사이의 최대 거리입니다. 이를 지키는 가장 적은 삼각형을 사용합니다. 0이면 삼각형 링을 사용합니다.</translation>
    </message>
    <message>
        <source>model units</source>
        <translation>모델 단위</translation>
    </message>
    <message>
        <source>Surface Cage</source>
        <translation>서피스 케이지</translation>
    </message>
    <message>
        <source>Makes a cage of quads for subdivision of a network of curves, with its creases tagged as sharp.</source>
        <translation>커브 네트워크로 서브디비전용 사각형 케이지를 만들고, 크리스에 날카로움 태그를 붙입니다.</translation>
    </message>
    <message>
        <source>Into how many edges a curve is divided.</source>
        <translation>커브 하나를 나누는 에지 수입니다.</translation>
    </message>
    <message>
        <source>Subdivide</source>
        <translation>세분화</translation>
    </message>
    <message>
        <source>Refines a cage of polygons into a smooth mesh; tagged edges stay sharp, in chains that are curves.</source>
        <translation>다각형 케이지를 매끄러운 메쉬로 세분화합니다. 태그가 붙은 에지는 체인마다 커브를 이루며 날카롭게 유지됩니다.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>스무딩</translation>
    </message>
    <message>
        <source>Rules of refinement; loop cuts polygons into triangles first.</source>
        <translation>세분화 규칙입니다. loop는 먼저 다각형을 삼각형으로 자릅니다.</translation>
    </message>
    <message>
        <source>Soft (Doo-Sabin)</source>
        <translation>부드럽게 (Doo-Sabin)</translation>
    </message>
    <message>
        <source>Standard (Catmull-Clark)</source>
        <translation>표준 (Catmull-Clark)</translation>
    </message>
    <message>
        <source>Triangles (Loop)</source>
        <translation>삼각형 (Loop)</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>품질</translation>
    </message>
    <message>
        <source>refined for round faces and smooth ends of chains, paper for Lee, Joo, Hong 2002; doo-sabin only.</source>
        <translation>refined는 둥근 페이스와 매끄러운 체인 끝, paper는 Lee, Joo, Hong 2002 방식입니다. doo-sabin에만 적용됩니다.</translation>
    </message>
    <message>
        <source>refined</source>
        <translation>개선된 방식</translation>
    </message>
    <message>
        <source>as published in 2002</source>
        <translation>2002년 논문 방식</translation>
    </message>
    <message>
        <source>Corners of faces</source>
        <translation>페이스 코너</translation>
    </message>
    <message>
        <source>How the corners of a face weigh in its new points.</source>
        <translation>페이스의 코너가 새 점에 미치는 가중치를 정합니다.</translation>
    </message>
    <message>
        <source>classical</source>
        <translation>고전 방식</translation>
    </message>
    <message>
        <source>as the quality</source>
        <translation>품질에 따름</translation>
    </message>
    <message>
        <source>Beside sharp edges</source>
        <translation>날카로운 에지 옆</translation>
    </message>
    <message>
        <source>Rows of faces beside a chain: clamped halves them at each level, plain keeps three quarters.</source>
        <translation>체인 옆의 페이스 줄입니다. clamped는 레벨마다 너비를 절반으로 줄이고, plain은 4분의 3을 유지합니다.</translation>
    </message>
    <message>
        <source>half as wide</source>
        <translation>절반 너비</translation>
    </message>
    <message>
        <source>three quarters as wide</source>
        <translation>4분의 3 너비</translation>
    </message>
    <message>
        <source>Ends of sharp edges</source>
        <translation>날카로운 에지의 끝</translation>
    </message>
    <message>
        <source>Where a chain of sharp edges ends in a surface: it runs out, draws back, or stays.</source>
        <translation>날카로운 에지 체인이 서피스 안에서 끝나는 곳의 처리입니다: 점차 사라지거나, 뒤로 물러나거나, 그대로 유지됩니다.</translation>
    </message>
    <message>
        <source>run out</source>
        <translation>점차 사라짐</translation>
    </message>
    <message>
        <source>draw back</source>
        <translation>뒤로 물러남</translation>
    </message>
    <message>
        <source>stay</source>
        <translation>유지</translation>
    </message>
    <message>
        <source>Corners of borders</source>
        <translation>경계 코너</translation>
    </message>
    <message>
        <source>Boundary vertices with a single face stay, or are rounded with the boundary.</source>
        <translation>페이스가 하나뿐인 경계 정점을 유지하거나, 경계와 함께 둥글립니다.</translation>
    </message>
    <message>
        <source>rounded</source>
        <translation>둥글게</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>레벨</translation>
    </message>
    <message>
        <source>How often the cage is refined; each level has about four times the faces.</source>
        <translation>케이지를 세분화하는 횟수입니다. 레벨마다 페이스가 약 4배로 늘어납니다.</translation>
    </message>
    <message>
        <source>Edges without a tag become sharp where faces meet at more than this; 0 for none.</source>
        <translation>태그가 없는 에지는 페이스가 이보다 큰 각도로 만나면 날카로워집니다. 0이면 적용하지 않습니다.</translation>
    </message>
    <message>
        <source>Corners of sharp edges above</source>
        <translation>날카로운 에지의 코너 최소 각도</translation>
    </message>
    <message>
        <source>Chains that turn by more than this at a vertex of the cage keep a corner there; 180 for none.</source>
        <translation>케이지의 정점에서 이보다 많이 꺾이는 체인은 그곳에 코너를 유지합니다. 180이면 코너가 없습니다.</translation>
    </message>
    <message>
        <source>On the final surface</source>
        <translation>최종 서피스에 맞추기</translation>
    </message>
    <message>
        <source>Move the vertices to where they would end after endless refinement.</source>
        <translation>무한히 세분화했을 때 놓일 위치로 정점을 옮깁니다.</translation>
    </message>
    <message>
        <source>Provenance</source>
        <translation>출처</translation>
    </message>
    <message>
        <source>Attach to faces and vertices which element of the cage they come from; doo-sabin only.</source>
        <translation>페이스와 정점에 케이지의 어느 요소에서 왔는지 기록합니다. doo-sabin에만 적용됩니다.</translation>
    </message>
    <message>
        <source>Even Out</source>
        <translation>고르게 펴기</translation>
    </message>
    <message>
        <source>Moves the points of a cage so that its Doo-Sabin surface bends less and more evenly.</source>
        <translation>Doo-Sabin 서피스가 덜, 그리고 더 고르게 휘도록 케이지의 점을 옮깁니다.</translation>
    </message>
    <message>
        <source>Hold back</source>
        <translation>원위치 유지</translation>
    </message>
    <message>
        <source>How much the points are held back: low values make the surface fairer, high ones leave it.</source>
        <translation>점을 제자리에 붙잡는 정도입니다. 낮으면 서피스가 더 고와지고, 높으면 그대로 유지됩니다.</translation>
    </message>
    <message>
        <source>/ (median edge length)²</source>
        <translation>/ (에지 길이 중앙값)²</translation>
    </message>
    <message>
        <source>Level that is looked at</source>
        <translation>평가 레벨</translation>
    </message>
    <message>
        <source>Level of subdivision at which the bending is measured.</source>
        <translation>휘어짐을 측정할 서브디비전 레벨입니다.</translation>
    </message>
    <message>
        <source>The points of sharp edges hold, or are evened out along their chains.</source>
        <translation>날카로운 에지의 점을 그대로 두거나, 체인을 따라 고르게 폅니다.</translation>
    </message>
    <message>
        <source>are evened out</source>
        <translation>고르게 펴기</translation>
    </message>
    <message>
        <source>Flat faces</source>
        <translation>평평한 페이스</translation>
    </message>
    <message>
        <source>Flat faces beside sharp edges and flat chains keep their planes, or not.</source>
        <translation>날카로운 에지와 평평한 체인 옆의 평평한 페이스가 평면을 유지할지 정합니다.</translation>
    </message>
    <message>
        <source>stay flat</source>
        <translation>평평하게 유지</translation>
    </message>
    <message>
        <source>may bend</source>
        <translation>휘어짐 허용</translation>
    </message>
    <message>
        <source>Rules of the Doo-Sabin surface.</source>
        <translation>Doo-Sabin 서피스의 규칙입니다.</translation>
    </message>
    <message>
        <source>Fill Holes</source>
        <translation>구멍 메우기</translation>
    </message>
    <message>
        <source>Closes the holes of a scan by patches that continue the surface and leaves everything else as it is, or remeshes the whole model.</source>
        <translation>서피스를 이어 가는 패치로 스캔의 구멍을 닫고 나머지는 그대로 두거나, 모델 전체를 리메쉬합니다.</translation>
    </message>
    <message>
        <source>patch closes holes and changes nothing else; remesh makes all of it of new triangles, from one function.</source>
        <translation>patch는 구멍만 닫고 다른 것은 바꾸지 않습니다. remesh는 하나의 함수로 전체를 새 삼각형으로 만듭니다.</translation>
    </message>
    <message>
        <source>patches</source>
        <translation>패치</translation>
    </message>
    <message>
        <source>a new mesh</source>
        <translation>새 메쉬</translation>
    </message>
    <message>
        <source>inner fills all holes that don't look like the border of an open surface; none only those that holes names.</source>
        <translation>inner는 열린 서피스의 경계로 보이지 않는 모든 구멍을 메웁니다. none은 holes에 지정한 구멍만 메웁니다.</translation>
    </message>
    <message>
        <source>inner holes</source>
        <translation>안쪽 구멍</translation>
    </message>
    <message>
        <source>all holes</source>
        <translation>모든 구멍</translation>
    </message>
    <message>
        <source>all but the largest</source>
        <translation>가장 큰 구멍만 제외</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Only</source>
        <translation>지정한 것만</translation>
    </message>
    <message>
        <source>Numbers of the holes to fill instead, as the list shows them: 0,3-5.</source>
        <translation>대신 메울 구멍의 번호입니다. 목록에 표시된 번호를 사용합니다: 0,3-5.</translation>
    </message>
    <message>
        <source>Widest hole</source>
        <translation>최대 구멍 너비</translation>
    </message>
    <message>
        <source>Wider holes stay open; 0 for no limit.</source>
        <translation>이보다 넓은 구멍은 열린 채로 둡니다. 0이면 제한이 없습니다.</translation>
    </message>
    <message>
        <source>Join edges within</source>
        <translation>에지 병합 거리</translation>
    </message>
    <message>
        <source>Vertices of rims so near to each other count as one, if the edges there are longer; the scan keeps them as they are. 0: only those at one place.</source>
        <translation>구멍 가장자리의 정점이 이 거리 안에 있고 그곳의 에지가 더 길면 하나로 취급합니다. 스캔에는 정점이 그대로 남습니다. 0이면 같은 위치의 정점만 해당합니다.</translation>
    </message>
    <message>
        <source>× diagonal</source>
        <translation>× 대각선</translation>
    </message>
    <message>
        <source>Requests for single holes: '3: leave; 5-7: flat, bulge 0.4; 4: through 1 2 3; 2+9: bridge'. Words: fill, leave, bridge, rbf, smooth, flat, kernel NAME, bulge -1..1, trim 0..3, through X Y Z.</source>
        <translation>개별 구멍에 대한 지정입니다: '3: leave; 5-7: flat, bulge 0.4; 4: through 1 2 3; 2+9: bridge'. 사용할 수 있는 단어: fill, leave, bridge, rbf, smooth, flat, kernel NAME, bulge -1..1, trim 0..3, through X Y Z.</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>패치</translation>
    </message>
    <message>
        <source>rbf continues the surface around by functions fitted to it, smooth its tangents; flat adds no vertices and has the least area; auto is flat where an open surface ends, and rbf elsewhere.</source>
        <translation>rbf는 주변 서피스에 맞춘 함수로 서피스를 이어 가고, smooth는 그 접선을 이어 갑니다. flat은 정점을 추가하지 않으며 면적이 가장 작습니다. auto는 열린 서피스가 끝나는 곳에서는 flat, 그 외에는 rbf입니다.</translation>
    </message>
    <message>
        <source>best for each hole</source>
        <translation>구멍마다 최적</translation>
    </message>
    <message>
        <source>continue the surface</source>
        <translation>서피스 이어 가기</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>평평하게</translation>
    </message>
    <message>
        <source>The functions of rbf: hermite takes normals along, the others points beside the surface; thin-plate with the preset paper.</source>
        <translation>rbf의 함수입니다. hermite는 노멀을 함께 사용하고, 나머지는 서피스 옆의 점을 사용합니다. 프리셋 paper에서는 thin-plate입니다.</translation>
    </message>
    <message>
        <source>with normals</source>
        <translation>노멀 사용</translation>
    </message>
    <message>
        <source>triharmonic</source>
        <translation>삼중조화 (Triharmonic)</translation>
    </message>
    <message>
        <source>biharmonic</source>
        <translation>이중조화 (Biharmonic)</translation>
    </message>
    <message>
        <source>thin plate</source>
        <translation>얇은 판 (Thin plate)</translation>
    </message>
    <message>
        <source>The scan is</source>
        <translation>스캔 종류</translation>
    </message>
    <message>
        <source>What is scanned: auto continues creases that run into a hole, standard rounds them; sharp for machined parts, where creases go on in holes of any size, noisy for rough scans; paper for comparison with Yoo 2005.</source>
        <translation>스캔한 대상입니다. auto는 구멍으로 이어지는 크리스를 연장하고, standard는 둥글립니다. sharp는 크기에 관계없이 구멍 안에서 크리스가 이어지는 기계 부품용, noisy는 거친 스캔용, paper는 Yoo 2005와의 비교용입니다.</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>일반</translation>
    </message>
    <message>
        <source>as published in 2005</source>
        <translation>2005년 논문 방식</translation>
    </message>
    <message>
        <source>a machined part</source>
        <translation>기계 부품</translation>
    </message>
    <message>
        <source>rough</source>
        <translation>거친 스캔</translation>
    </message>
    <message>
        <source>Turns the surface at the rims outwards, or inwards below 0.</source>
        <translation>구멍 가장자리의 서피스를 바깥쪽으로, 0보다 작으면 안쪽으로 기울입니다.</translation>
    </message>
    <message>
        <source>Trim edge</source>
        <translation>가장자리 다듬기</translation>
    </message>
    <message>
        <source>Removes so much of the scan along the rims that are filled, where scans are worst.</source>
        <translation>스캔 품질이 가장 나쁜, 메울 구멍의 가장자리를 따라 스캔을 이만큼 제거합니다.</translation>
    </message>
    <message>
        <source>rings of faces</source>
        <translation>페이스 링</translation>
    </message>
    <message>
        <source>New mesh: overlap</source>
        <translation>새 메쉬: 겹침</translation>
    </message>
    <message>
        <source>remesh: how much larger domains are than their boxes; 0.1 with the preset paper.</source>
        <translation>remesh: 도메인이 그 상자보다 얼마나 더 큰지 정합니다. 프리셋 paper에서는 0.1입니다.</translation>
    </message>
    <message>
        <source>× domain</source>
        <translation>× 도메인</translation>
    </message>
    <message>
        <source>Points per domain</source>
        <translation>도메인당 점 수</translation>
    </message>
    <message>
        <source>remesh: least and most points of a domain, MIN:MAX.</source>
        <translation>remesh: 도메인의 최소 및 최대 점 수입니다, MIN:MAX.</translation>
    </message>
    <message>
        <source>New mesh: evened out</source>
        <translation>새 메쉬: 고르게 펴기</translation>
    </message>
    <message>
        <source>remesh: how often the triangles are evened out on the surface.</source>
        <translation>remesh: 서피스 위에서 삼각형을 고르게 펴는 횟수입니다.</translation>
    </message>
    <message>
        <source>rounds</source>
        <translation>회</translation>
    </message>
    <message>
        <source>New mesh: each triangle cut in four</source>
        <translation>새 메쉬: 삼각형을 넷으로 나누기</translation>
    </message>
    <message>
        <source>remesh: how often every triangle is cut in four.</source>
        <translation>remesh: 모든 삼각형을 넷으로 나누는 횟수입니다.</translation>
    </message>
    <message>
        <source>times</source>
        <translation>회</translation>
    </message>
    <message>
        <source>New mesh: edges</source>
        <translation>새 메쉬: 에지</translation>
    </message>
    <message>
        <source>remesh: edge of the cubes; small ones keep more detail and take more memory. 0.5 with the preset sharp.</source>
        <translation>remesh: 정육면체의 에지 길이입니다. 작을수록 디테일이 더 유지되고 메모리를 더 사용합니다. 프리셋 sharp에서는 0.5입니다.</translation>
    </message>
    <message>
        <source>× mean edge</source>
        <translation>× 평균 에지</translation>
    </message>
    <message>
        <source>New mesh: fewer faces where flat</source>
        <translation>새 메쉬: 평평한 곳의 페이스 줄이기</translation>
    </message>
    <message>
        <source>remesh: fewer faces where the surface is flat: they are merged as long as the surface stays this near to what it was. 0: none are; 0.1 is usual.</source>
        <translation>remesh: 서피스가 평평한 곳의 페이스를 줄입니다. 서피스가 원래 모양과 이 거리 안에 있는 한 페이스를 병합합니다. 0이면 병합하지 않으며, 보통 0.1을 사용합니다.</translation>
    </message>
    <message>
        <source>× cell</source>
        <translation>× 셀</translation>
    </message>
    <message>
        <source>Most memory</source>
        <translation>최대 메모리</translation>
    </message>
    <message>
        <source>A mesh that would take more is refused before anything is allocated; 0 for no limit.</source>
        <translation>이보다 많은 메모리가 필요한 메쉬는 할당하기 전에 거부합니다. 0이면 제한이 없습니다.</translation>
    </message>
    <message>
        <source>MiB</source>
        <translation>MiB</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>정밀도</translation>
    </message>
    <message>
        <source>How coordinates will be stored, by which patches are judged; files of single numbers set it.</source>
        <translation>좌표를 저장할 정밀도이며, 이를 기준으로 패치를 평가합니다. 단정밀도 파일에서는 자동으로 설정됩니다.</translation>
    </message>
    <message>
        <source>double</source>
        <translation>배정밀도</translation>
    </message>
    <message>
        <source>single</source>
        <translation>단정밀도</translation>
    </message>
    <message>
        <source>Mark patches</source>
        <translation>패치 표시</translation>
    </message>
    <message>
        <source>Mark each face with the number of its patch, -1 for the scan's own, and each vertex with a confidence; files other than PLY can't hold them.</source>
        <translation>각 페이스에는 패치 번호(스캔 자체의 페이스는 -1)를, 각 정점에는 신뢰도를 기록합니다. PLY 이외의 파일에는 저장할 수 없습니다.</translation>
    </message>
    <message>
        <source>List</source>
        <translation>목록</translation>
    </message>
    <message>
        <source>Only list the holes and which of them would be filled; write nothing.</source>
        <translation>구멍과 그중 메울 구멍의 목록만 표시하고, 아무것도 저장하지 않습니다.</translation>
    </message>
    <message>
        <source>Patch by Curves</source>
        <translation>커브로 패치</translation>
    </message>
    <message>
        <source>Closes holes of a mesh exactly along their rims by attribute surfaces that continue the faces around.</source>
        <translation>주변 페이스를 이어 가는 속성 서피스로 메쉬의 구멍을 가장자리에 정확히 맞춰 닫습니다.</translation>
    </message>
    <message>
        <source>Holes, such as 0,3-5</source>
        <translation>구멍 번호 (예: 0,3-5)</translation>
    </message>
    <message>
        <source>Numbers of the holes to close, as the list of fill shows them: 0,3-5; empty for all.</source>
        <translation>닫을 구멍의 번호입니다. fill의 목록에 표시된 번호를 사용합니다: 0,3-5. 비워 두면 모두 닫습니다.</translation>
    </message>
    <message>
        <source>Hole at vertex</source>
        <translation>정점이 속한 구멍</translation>
    </message>
    <message>
        <source>Closes the holes that have this vertex in their rims, counted from 0; -1 for none.</source>
        <translation>이 정점이 가장자리에 있는 구멍을 닫습니다. 정점은 0부터 세며, -1이면 지정하지 않습니다.</translation>
    </message>
    <message>
        <source>Meets the faces around</source>
        <translation>주변 페이스와의 연결</translation>
    </message>
    <message>
        <source>smooth continues the faces around, crease meets them at an angle.</source>
        <translation>smooth는 주변 페이스를 매끄럽게 이어 가고, crease는 각지게 만납니다.</translation>
    </message>
    <message>
        <source>smoothly</source>
        <translation>매끄럽게</translation>
    </message>
    <message>
        <source>at an angle</source>
        <translation>각지게</translation>
    </message>
    <message>
        <source>Rims that turn more have a corner between two sides there.</source>
        <translation>이보다 많이 꺾이는 구멍 가장자리는 그곳에서 두 변 사이에 코너가 생깁니다.</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>변</translation>
    </message>
    <message>
        <source>Sides that a rim is divided into, 3 to 12; 0 for as many as it has corners.</source>
        <translation>구멍 가장자리를 나누는 변의 수(3~12)입니다. 0이면 코너 수와 같습니다.</translation>
    </message>
    <message>
        <source>How far slopes at the rim reach into the patch, -1 to 2; auto finds the height that the rim lets expect.</source>
        <translation>구멍 가장자리의 기울기가 패치 안으로 미치는 정도(-1~2)입니다. auto는 가장자리에서 예상되는 높이를 찾습니다.</translation>
    </message>
    <message>
        <source>Edges inside the patch: smaller is finer.</source>
        <translation>패치 안쪽의 에지 길이입니다. 작을수록 세밀합니다.</translation>
    </message>
    <message>
        <source>× mean edge of the rim</source>
        <translation>× 구멍 가장자리 평균 에지</translation>
    </message>
    <message>
        <source>Applies edits to a mesh, one after the other: move, extrude, inset, cut, dissolve, tag.</source>
        <translation>메쉬에 편집을 차례로 적용합니다: 이동, 돌출, 인셋, 자르기, 디졸브, 태그.</translation>
    </message>
    <message>
        <source>Edits</source>
        <translation>편집 목록</translation>
    </message>
    <message>
        <source>Edits in their order: 'extrude faces=3,4 by=0,0,1'; see `croquis-cli edits`.</source>
        <translation>순서대로 적용할 편집입니다: 'extrude faces=3,4 by=0,0,1'. `croquis-cli edits`를 참고하세요.</translation>
    </message>
    <message>
        <source>Connectivity</source>
        <translation>연결 구조</translation>
    </message>
    <message>
        <source>Refuses meshes whose faces are joined in another way, by the name in the details; empty: takes any.</source>
        <translation>페이스의 연결 방식이 여기에 지정한 이름(세부 정보에 표시됨)과 다른 메쉬를 거부합니다. 비워 두면 모두 허용합니다.</translation>
    </message>
    <message>
        <source>Moves vertices, or those of edges and faces.</source>
        <translation>정점, 또는 에지와 페이스의 정점을 이동합니다.</translation>
    </message>
    <message>
        <source>By x, y, z</source>
        <translation>이동량 x, y, z</translation>
    </message>
    <message>
        <source>How far, along x, y and z, in model units.</source>
        <translation>x, y, z 방향의 이동 거리이며 모델 단위입니다.</translation>
    </message>
    <message>
        <source>Rotates vertices, or those of edges and faces, about a point.</source>
        <translation>정점, 또는 에지와 페이스의 정점을 한 점을 중심으로 회전합니다.</translation>
    </message>
    <message>
        <source>Axis x, y, z</source>
        <translation>회전축 x, y, z</translation>
    </message>
    <message>
        <source>The axis; its length doesn't matter.</source>
        <translation>회전축입니다. 길이는 상관없습니다.</translation>
    </message>
    <message>
        <source>The angle, counter-clockwise seen against the axis.</source>
        <translation>축이 보는 사람을 향할 때 시계 반대 방향으로 잰 각도입니다.</translation>
    </message>
    <message>
        <source>About x, y, z</source>
        <translation>회전 중심 x, y, z</translation>
    </message>
    <message>
        <source>A point on the axis; if not given, the mean of the vertices.</source>
        <translation>축 위의 한 점입니다. 지정하지 않으면 정점들의 평균 위치입니다.</translation>
    </message>
    <message>
        <source>Scales vertices, or those of edges and faces, from a point.</source>
        <translation>정점, 또는 에지와 페이스의 정점을 한 점을 기준으로 크기 조절합니다.</translation>
    </message>
    <message>
        <source>Times x, y, z</source>
        <translation>배율 x, y, z</translation>
    </message>
    <message>
        <source>The factors along x, y and z.</source>
        <translation>x, y, z 방향의 배율입니다.</translation>
    </message>
    <message>
        <source>The point that stays; if not given, the mean of the vertices.</source>
        <translation>움직이지 않는 점입니다. 지정하지 않으면 정점들의 평균 위치입니다.</translation>
    </message>
    <message>
        <source>Extrude</source>
        <translation>돌출</translation>
    </message>
    <message>
        <source>Lifts faces off and joins them to where they were by walls.</source>
        <translation>페이스를 들어 올리고 원래 자리와 벽으로 연결합니다.</translation>
    </message>
    <message>
        <source>How far, along x, y and z, in model units; if not given, `distance` counts.</source>
        <translation>x, y, z 방향의 거리이며 모델 단위입니다. 지정하지 않으면 `distance`를 사용합니다.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>거리</translation>
    </message>
    <message>
        <source>How far along the mean normal of the faces; not used where `by` is given.</source>
        <translation>페이스의 평균 노멀 방향 거리입니다. `by`를 지정하면 사용하지 않습니다.</translation>
    </message>
    <message>
        <source>Inset</source>
        <translation>인셋</translation>
    </message>
    <message>
        <source>Draws the border of faces inwards and fills the strip between with quads.</source>
        <translation>페이스의 경계를 안쪽으로 당기고 그 사이의 띠를 사각형으로 채웁니다.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>너비</translation>
    </message>
    <message>
        <source>Width of the strip.</source>
        <translation>띠의 너비입니다.</translation>
    </message>
    <message>
        <source>Cuts the quads that lie opposite to each other across an edge, all around.</source>
        <translation>에지를 사이에 두고 마주 보며 이어지는 사각형을 한 바퀴 빙 둘러 자릅니다.</translation>
    </message>
    <message>
        <source>At</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Where the edge is cut, from its first vertex.</source>
        <translation>에지를 자르는 위치이며, 첫 번째 정점부터 잽니다.</translation>
    </message>
    <message>
        <source>share of the edge</source>
        <translation>에지 길이 비율</translation>
    </message>
    <message>
        <source>Dissolve</source>
        <translation>디졸브</translation>
    </message>
    <message>
        <source>Removes edges or vertices and makes one face of those around each.</source>
        <translation>에지나 정점을 제거하고 각각의 주변 페이스를 하나로 합칩니다.</translation>
    </message>
    <message>
        <source>Removes faces, and the vertices that only they had.</source>
        <translation>페이스와, 그 페이스에만 속한 정점을 제거합니다.</translation>
    </message>
    <message>
        <source>Sharpen</source>
        <translation>날카롭게</translation>
    </message>
    <message>
        <source>Tags edges, so that subdivision keeps them sharp.</source>
        <translation>에지에 태그를 붙여 서브디비전에서 날카롭게 유지합니다.</translation>
    </message>
    <message>
        <source>Sharp for</source>
        <translation>날카로움 유지 레벨</translation>
    </message>
    <message>
        <source>For how many levels edges stay sharp; 0 removes their tags, from 10 on they stay sharp.</source>
        <translation>에지를 날카롭게 유지할 레벨 수입니다. 0이면 태그를 제거하고, 10 이상이면 계속 날카롭게 유지합니다.</translation>
    </message>
    <message>
        <source>levels</source>
        <translation>레벨</translation>
    </message>
    <message>
        <source>Pins vertices, so that subdivision keeps them where they are, or lets them go.</source>
        <translation>정점을 고정해 서브디비전에서 제자리에 유지하거나, 고정을 해제합니다.</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>고정됨</translation>
    </message>
    <message>
        <source>false lets the vertices go.</source>
        <translation>false이면 정점의 고정을 해제합니다.</translation>
    </message>
</context>
</TS>
