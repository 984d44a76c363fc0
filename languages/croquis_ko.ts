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
        <source>Unit: %1</source>
        <translation>단위: %1</translation>
    </message>
    <message>
        <source>Reset to default</source>
        <translation>기본값으로 재설정</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>자동</translation>
    </message>
    <message>
        <source>Keep proportions</source>
        <translation>비율 유지</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>크기</translation>
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
        <source>Position, %1</source>
        <translation>위치, %1</translation>
    </message>
    <message>
        <source>Rotation, °</source>
        <translation>회전, °</translation>
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
        <source>Nothing is wrong. Problems of drawings and meshes are listed here.</source>
        <translation>문제가 없습니다. 드로잉과 메쉬의 문제는 여기에 나열됩니다.</translation>
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
        <source>What you draw or open is listed here.</source>
        <translation>그리거나 연 것이 여기에 나열됩니다.</translation>
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
        <source>Perspective drawing</source>
        <translation>투시 드로잉</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>커브</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>메쉬</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>시작 페이지</translation>
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
        <source>Tours</source>
        <translation>튜토리얼</translation>
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
        <source>Versions</source>
        <translation>버전</translation>
    </message>
    <message>
        <source>A version: click shows it, the right button what can be done</source>
        <translation>버전: 클릭하면 표시하고, 오른쪽 버튼으로 할 수 있는 일을 봅니다</translation>
    </message>
    <message>
        <source>Steps of the history</source>
        <translation>작업 내역의 단계</translation>
    </message>
    <message>
        <source>Drag to go through the steps of the history</source>
        <translation>끌어서 작업 내역의 단계를 훑어봅니다</translation>
    </message>
    <message>
        <source>Save version…</source>
        <translation>버전 저장…</translation>
    </message>
    <message>
        <source>Compare with the chosen version</source>
        <translation>선택한 버전과 비교</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>비교</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>이름 바꾸기</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>삭제</translation>
    </message>
    <message>
        <source>Save version</source>
        <translation>버전 저장</translation>
    </message>
    <message>
        <source>Name of the model as it is now:</source>
        <translation>지금 모델의 이름:</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>버전 %1</translation>
    </message>
    <message>
        <source>A version needs a name.</source>
        <translation>버전에는 이름이 필요합니다.</translation>
    </message>
    <message>
        <source>The version "%1" is saved. The panel History shows it again, and the project keeps it.</source>
        <translation>버전 "%1"을(를) 저장했습니다. 작업 내역 패널에서 다시 표시할 수 있고, 프로젝트에 보관됩니다.</translation>
    </message>
    <message>
        <source>Delete the version "%1"? This can't be undone.</source>
        <translation>버전 "%1"을(를) 삭제할까요? 실행 취소할 수 없습니다.</translation>
    </message>
    <message>
        <source>Delete version</source>
        <translation>버전 삭제</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>현재</translation>
    </message>
    <message>
        <source>no faces</source>
        <translation>페이스 없음</translation>
    </message>
    <message>
        <source>No hole is selected: click one in the list or in a view</source>
        <translation>선택된 구멍이 없습니다. 목록이나 뷰에서 구멍을 클릭하세요</translation>
    </message>
    <message>
        <source>Select two rims to bridge: click one, then Shift+click the other</source>
        <translation>브리지할 구멍 가장자리 두 개를 선택하세요. 하나를 클릭한 다음 다른 하나를 Shift+클릭합니다</translation>
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
        <source>No holes</source>
        <translation>구멍 없음</translation>
    </message>
    <message>
        <source>%1 filled</source>
        <translation>%1 메움</translation>
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
        <source>%1 and %2 more</source>
        <translation>%1 외 %2개</translation>
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
        <source>By angle</source>
        <translation>각도 기준</translation>
    </message>
    <message>
        <source>Drag: edges whose faces meet at a greater angle are selected and counted</source>
        <translation>드래그: 페이스가 이보다 큰 각도로 만나는 에지를 선택하고 개수를 셉니다</translation>
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
        <source>%1 pins</source>
        <translation>고정 정점 %1개</translation>
    </message>
    <message>
        <source>%1 edges, %2</source>
        <translation>에지 %1개, %2</translation>
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
        <source>Forgets the set; its edges stay as sharp as they are</source>
        <translation>세트를 삭제합니다. 에지의 날카로움은 그대로 유지됩니다</translation>
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
        <source>Lines</source>
        <translation>선 목록</translation>
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
        <source>Body</source>
        <translation>몸통</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>머리</translation>
    </message>
    <message>
        <source>Ear</source>
        <translation>귀</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>눈</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>팔</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>다리</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>꼬리</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>부위</translation>
    </message>
    <message>
        <source>Left %1</source>
        <translation>왼쪽 %1</translation>
    </message>
    <message>
        <source>Right %1</source>
        <translation>오른쪽 %1</translation>
    </message>
    <message>
        <source>Part %1</source>
        <translation>부위 %1</translation>
    </message>
    <message>
        <source>Other readings of the sketch</source>
        <translation>스케치의 다른 해석</translation>
    </message>
    <message>
        <source>Looking for other readings…</source>
        <translation>다른 해석을 찾는 중…</translation>
    </message>
    <message>
        <source>Looking for more…</source>
        <translation>더 찾는 중…</translation>
    </message>
    <message>
        <source>No other reading</source>
        <translation>다른 해석이 없습니다</translation>
    </message>
    <message>
        <source>As it is read now</source>
        <translation>지금 인식된 대로</translation>
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
        <source>Draw the middle line of a tube, it may cross itself: pressure makes it thicker · D draws outlines</source>
        <translation>튜브의 중심선을 그립니다. 자신과 교차해도 됩니다 · 필압을 주면 굵어집니다 · D는 윤곽선을 그립니다</translation>
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
        <source>Colour of part</source>
        <translation>부위 색</translation>
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
        <source>Quad cage</source>
        <translation>쿼드 케이지</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>그리기</translation>
    </message>
    <message>
        <source>Draw tubes</source>
        <translation>튜브 그리기</translation>
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
        <source>Second one on the far side</source>
        <translation>반대쪽에 하나 더</translation>
    </message>
    <message>
        <source>Other readings</source>
        <translation>다른 해석</translation>
    </message>
    <message>
        <source>Colour of part…</source>
        <translation>부위 색…</translation>
    </message>
    <message>
        <source>Symmetric drawing</source>
        <translation>대칭 드로잉</translation>
    </message>
    <message>
        <source>Mirror selected lines</source>
        <translation>선택한 선 대칭으로</translation>
    </message>
    <message>
        <source>Tube radius</source>
        <translation>튜브 반지름</translation>
    </message>
    <message>
        <source>%1 % of the view</source>
        <translation>뷰의 %1 %</translation>
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
        <source>(read from the drawing)</source>
        <translation>(드로잉에서 인식함)</translation>
    </message>
    <message>
        <source>%1: %2. Click (with Q) to make it something else</source>
        <translation>%1: %2. (Q 모드에서) 클릭하면 다른 종류로 바꿀 수 있습니다</translation>
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
        <source>In front: %1. Behind: %2. Click to swap them</source>
        <translation>앞: %1. 뒤: %2. 클릭하면 서로 바뀝니다</translation>
    </message>
    <message>
        <source>%1 passes over itself. Click to swap the strands</source>
        <translation>%1이(가) 자신의 위로 지나갑니다. 클릭하면 두 가닥이 뒤바뀝니다</translation>
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
        <translation>사슬</translation>
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
        <source>Stretch %1×</source>
        <translation>늘어남 %1×</translation>
    </message>
    <message>
        <source> (uniform %1×)</source>
        <translation> (균일 %1×)</translation>
    </message>
    <message>
        <source>Dent of point %1: off by %2 (uniform %3), %4 times as long as wide (uniform %5)</source>
        <translation>포인트 %1의 함몰: 어긋남 %2 (균일 %3), 길이가 너비의 %4배 (균일 %5)</translation>
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
        <source>Show me</source>
        <translation>시연</translation>
    </message>
    <message>
        <source>Does this step for you</source>
        <translation>이 단계를 대신 실행합니다</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>건너뛰기</translation>
    </message>
    <message>
        <source>Goes on without this step</source>
        <translation>이 단계 없이 넘어갑니다</translation>
    </message>
    <message>
        <source>End tour</source>
        <translation>튜토리얼 종료</translation>
    </message>
    <message>
        <source>Ends the tour; what is drawn stays</source>
        <translation>튜토리얼을 끝냅니다. 그린 것은 그대로 남습니다</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>%2단계 중 %1단계</translation>
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
        <source>Drag to rotate the view</source>
        <translation>드래그하면 뷰가 회전합니다</translation>
    </message>
    <message>
        <source>Drag to pan the view</source>
        <translation>드래그하면 뷰가 이동합니다</translation>
    </message>
    <message>
        <source>Drag up or down to zoom</source>
        <translation>위아래로 드래그하면 확대/축소합니다</translation>
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
        <source>rotate</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>줌</translation>
    </message>
    <message>
        <source>Pen with pressure</source>
        <translation>필압 있는 펜</translation>
    </message>
    <message>
        <source>Pen without pressure</source>
        <translation>필압 없는 펜</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>마우스</translation>
    </message>
    <message>
        <source>Welcome to Croquis</source>
        <translation>Croquis에 오신 것을 환영합니다</translation>
    </message>
    <message>
        <source>Choose what you are used to. Edit &gt; Preferences changes it later.</source>
        <translation>익숙한 방식을 선택하십시오. 나중에 편집 &gt; 환경 설정에서 바꿀 수 있습니다.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>언어</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>테마</translation>
    </message>
    <message>
        <source>&amp;Keys as in</source>
        <translation>단축키 방식</translation>
    </message>
    <message>
        <source>&amp;Navigation as in</source>
        <translation>화면 조작 방식</translation>
    </message>
    <message>
        <source>Draw on the strip</source>
        <translation>위 칸에 그려 보십시오</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>펜</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>시작</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>폴더 열기</translation>
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
        <source>What's this?</source>
        <translation>이것은 무엇입니까?</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>문제 보고…</translation>
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
        <source>Preferences</source>
        <translation>환경 설정</translation>
    </message>
    <message>
        <source>Search commands and keys</source>
        <translation>명령 및 단축키 검색</translation>
    </message>
    <message>
        <source>S&amp;cale</source>
        <translation>스케일</translation>
    </message>
    <message>
        <source>A scale takes effect at the next start</source>
        <translation>배율은 다음에 시작할 때 적용됩니다</translation>
    </message>
    <message>
        <source>Wrote %1: attach it where you ask for help</source>
        <translation>%1을(를) 썼습니다. 도움을 요청하는 곳에 첨부하십시오</translation>
    </message>
    <message>
        <source>Report a problem</source>
        <translation>문제 보고</translation>
    </message>
    <message>
        <source>The report is one text file. It has the versions of Croquis and the system, the graphics card, the window's settings, the number of vertices and faces of each object, kinds of findings, and when the window was slow. Nothing is sent: attach the file where you ask for help.</source>
        <translation>보고서는 텍스트 파일 하나입니다. Croquis와 시스템의 버전, 그래픽 카드, 창 설정, 각 오브젝트의 버텍스와 페이스 수, 검사 결과의 종류, 창이 느렸던 때가 들어 있습니다. 아무것도 보내지 않습니다. 도움을 요청하는 곳에 파일을 첨부하십시오.</translation>
    </message>
    <message>
        <source>With the strokes and commands since the document was opened, and the sentences of findings</source>
        <translation>문서를 연 뒤의 획과 명령, 검사 결과의 문장 포함</translation>
    </message>
    <message>
        <source>With the document</source>
        <translation>문서 포함</translation>
    </message>
    <message>
        <source>It will be written to:</source>
        <translation>저장할 위치:</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>복사</translation>
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
        <source>Dark</source>
        <translation>어둡게</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>밝게</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>고대비</translation>
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
        <source>Save</source>
        <translation>저장</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>다른 이름으로 저장…</translation>
    </message>
    <message>
        <source>Save increment</source>
        <translation>증분 저장</translation>
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
        <source>Numbers of what is selected can be changed here.</source>
        <translation>선택한 것의 값을 여기에서 바꿀 수 있습니다.</translation>
    </message>
    <message>
        <source>Sketch a character</source>
        <translation>캐릭터 스케치</translation>
    </message>
    <message>
        <source>Draw the body: begin at the dot, follow the dotted line and come back. It becomes solid at once.</source>
        <translation>몸체를 그리세요. 점에서 시작해 점선을 따라 돌아오면 바로 솔리드가 됩니다.</translation>
    </message>
    <message>
        <source>Draw the head. It crosses the body: the outline that is drawn later lies in front.</source>
        <translation>머리를 그리세요. 몸체와 겹치며, 나중에 그린 윤곽선이 앞에 놓입니다.</translation>
    </message>
    <message>
        <source>Hold Shift and draw both ears: they lie behind the head, so their lines stop at it.</source>
        <translation>Shift를 누른 채 두 귀를 그리세요. 머리 뒤에 놓이므로 선은 머리에서 멈춥니다.</translation>
    </message>
    <message>
        <source>Draw both eyes: closed lines within another one are parts in front.</source>
        <translation>두 눈을 그리세요. 윤곽선 안의 닫힌 선은 앞쪽 부위가 됩니다.</translation>
    </message>
    <message>
        <source>Draw each arm as a single line that begins on the body. An open line becomes a limb.</source>
        <translation>팔은 몸체에서 시작하는 선 하나로 그리세요. 열린 선은 팔다리가 됩니다.</translation>
    </message>
    <message>
        <source>Choose View &gt; Four views to see your character from all sides.</source>
        <translation>뷰 &gt; 4분할 뷰를 선택해 캐릭터를 여러 방향에서 보세요.</translation>
    </message>
    <message>
        <source>Your character is solid. Drag in the perspective view to look around it, draw more, or export it with File &gt; Export mesh.</source>
        <translation>캐릭터가 솔리드로 완성되었습니다. 투시 뷰에서 드래그해 둘러보거나, 더 그리거나, 파일 &gt; 메쉬 내보내기로 내보내세요.</translation>
    </message>
    <message>
        <source>A box in perspective</source>
        <translation>투시로 그린 상자</translation>
    </message>
    <message>
        <source>Draw the edge of the box that is nearest to you, from the dot along the dotted line.</source>
        <translation>가장 가까운 상자 에지를 점에서 점선을 따라 그리세요.</translation>
    </message>
    <message>
        <source>Draw the two upper edges that leave it. They run towards two vanishing points.</source>
        <translation>위쪽 끝에서 나가는 두 에지를 그리세요. 두 소실점을 향합니다.</translation>
    </message>
    <message>
        <source>Draw the two lower edges in the same way. Ends that come near a corner go to it.</source>
        <translation>아래쪽 두 에지도 똑같이 그리세요. 모서리 가까이에서 끝나는 선은 그 모서리에 붙습니다.</translation>
    </message>
    <message>
        <source>Draw the two outer upright edges.</source>
        <translation>바깥쪽의 세로 에지 두 개를 그리세요.</translation>
    </message>
    <message>
        <source>Close the top with its two far edges.</source>
        <translation>뒤쪽의 두 에지로 윗면을 닫으세요.</translation>
    </message>
    <message>
        <source>Draw the three edges that the box hides, as if it were made of glass. Then it is closed.</source>
        <translation>유리 상자처럼, 가려진 에지 세 개를 그리세요. 그러면 상자가 닫힙니다.</translation>
    </message>
    <message>
        <source>The box is a solid with true proportions. Rotate it in the perspective view, or give an edge its length in the panel Perspective.</source>
        <translation>상자가 실제 비율의 솔리드가 되었습니다. 투시 뷰에서 돌려 보거나, 투시 패널에서 에지의 길이를 지정하세요.</translation>
    </message>
    <message>
        <source>A surface from curves</source>
        <translation>커브로 만드는 서피스</translation>
    </message>
    <message>
        <source>Draw the first curve on the ground, from the dot along the dotted line.</source>
        <translation>첫 번째 커브를 점에서 점선을 따라 지면에 그리세요.</translation>
    </message>
    <message>
        <source>Draw the second curve from the end of the first one: ends that come near each other meet.</source>
        <translation>첫 번째 커브의 끝에서 두 번째 커브를 그리세요. 가까운 끝끼리는 이어집니다.</translation>
    </message>
    <message>
        <source>Draw an arch back to the beginning. Between two ends a curve may rise from the ground.</source>
        <translation>처음으로 돌아오는 아치를 그리세요. 두 끝 사이의 커브는 지면 위로 솟을 수 있습니다.</translation>
    </message>
    <message>
        <source>The curves close a loop. Press Patch, or the Enter key: a smooth patch fills it.</source>
        <translation>커브가 닫힌 루프를 이룹니다. 패치 버튼이나 Enter 키를 누르면 매끄러운 패치가 채워집니다.</translation>
    </message>
    <message>
        <source>Choose the tool Point on a patch.</source>
        <translation>패치 위의 점 도구를 선택하세요.</translation>
    </message>
    <message>
        <source>Press on the patch inside the ring and pull it down: a soft dent.</source>
        <translation>고리 안에서 패치를 누른 채 아래로 끌면 부드럽게 들어갑니다.</translation>
    </message>
    <message>
        <source>Choose View &gt; Zebra stripes: even stripes without kinks show a smooth surface.</source>
        <translation>뷰 &gt; 지브라 줄무늬를 선택하세요. 꺾이지 않고 고른 줄무늬는 매끄러운 서피스를 뜻합니다.</translation>
    </message>
    <message>
        <source>Three curves and one dent make a smooth surface. Drag a curve with the tool Select, or draw more curves to add patches.</source>
        <translation>커브 세 개와 점 하나로 매끄러운 서피스가 완성되었습니다. 선택 도구로 커브를 끌거나, 커브를 더 그려 패치를 추가하세요.</translation>
    </message>
    <message>
        <source>Sharp edges on a cage</source>
        <translation>케이지의 날카로운 에지</translation>
    </message>
    <message>
        <source>A coarse cage becomes a smooth screw. Choose Mesh &gt; Subdivision &gt; Cage and smooth surface to see both.</source>
        <translation>거친 케이지가 매끄러운 나사가 됩니다. 메쉬 &gt; 서브디비전 &gt; 케이지와 스무스 서피스를 선택해 둘 다 보세요.</translation>
    </message>
    <message>
        <source>Choose Edges, so that a click picks edges of the cage.</source>
        <translation>에지를 선택하세요. 그러면 클릭으로 케이지의 에지를 고를 수 있습니다.</translation>
    </message>
    <message>
        <source>Double-click the edge in the ring: the whole loop around the head is picked.</source>
        <translation>고리 안의 에지를 더블 클릭하세요. 머리를 도는 루프 전체가 선택됩니다.</translation>
    </message>
    <message>
        <source>Press Sharp: the surface folds along this loop and stays smooth elsewhere.</source>
        <translation>날카롭게를 누르세요. 서피스가 이 루프를 따라 꺾이고 나머지는 매끄럽게 유지됩니다.</translation>
    </message>
    <message>
        <source>Choose Mesh &gt; Subdivision &gt; Finer: smaller faces, the same shape.</source>
        <translation>메쉬 &gt; 서브디비전 &gt; 더 세밀하게를 선택하세요. 형태는 같고 페이스가 더 작아집니다.</translation>
    </message>
    <message>
        <source>Choose Mesh &gt; Subdivision &gt; Smooth surface to see the result alone.</source>
        <translation>메쉬 &gt; 서브디비전 &gt; 스무스 서피스를 선택해 결과만 보세요.</translation>
    </message>
    <message>
        <source>The screw has a crisp rim. Change the sharpness of any edge in the panel Sharp edges, or drag with the tool Change sharpness.</source>
        <translation>나사 머리에 선명한 에지가 생겼습니다. 날카로운 에지 패널에서 값을 바꾸거나, 날카로움 변경 도구로 드래그하세요.</translation>
    </message>
    <message>
        <source>Fill the holes of a scan</source>
        <translation>스캔의 구멍 메우기</translation>
    </message>
    <message>
        <source>This scan has holes. Click the one in the ring: its border is picked, and a preview shows the patch.</source>
        <translation>이 스캔에는 구멍이 있습니다. 고리 안의 구멍을 클릭하면 경계가 선택되고 패치를 미리 볼 수 있습니다.</translation>
    </message>
    <message>
        <source>Press Fill in the panel Holes. The patch continues the surface around it.</source>
        <translation>구멍 패널에서 메우기를 누르세요. 패치가 주변 서피스를 이어 갑니다.</translation>
    </message>
    <message>
        <source>Press Fill all inner: all holes are closed but the open border below.</source>
        <translation>내부 모두 메우기를 누르세요. 아래쪽의 열린 경계만 남고 모든 구멍이 닫힙니다.</translation>
    </message>
    <message>
        <source>Choose View &gt; Patches by confidence: the legend shows how certain each patch is.</source>
        <translation>뷰 &gt; 신뢰도별 패치 색상을 선택하세요. 각 패치가 얼마나 확실한지 범례에 나옵니다.</translation>
    </message>
    <message>
        <source>Choose View &gt; Zebra stripes: they run on across a good patch.</source>
        <translation>뷰 &gt; 지브라 줄무늬를 선택하세요. 좋은 패치에서는 줄무늬가 끊기지 않고 이어집니다.</translation>
    </message>
    <message>
        <source>The scan is closed, and what was scanned stays untouched. Choose another method or bulge in the panel Holes, then export the mesh.</source>
        <translation>구멍이 메워졌고, 스캔된 부분은 그대로입니다. 구멍 패널에서 방법이나 볼록함을 바꾼 뒤 메쉬를 내보내세요.</translation>
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
        <source>wavy</source>
        <translation>굽이지게</translation>
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
        <source>tilted</source>
        <translation>기울게</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>평평하게</translation>
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
        <source>deep</source>
        <translation>깊게</translation>
    </message>
    <message>
        <source>shallow</source>
        <translation>얕게</translation>
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
        <source>narrow</source>
        <translation>좁게</translation>
    </message>
    <message>
        <source>wide</source>
        <translation>넓게</translation>
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
        <source>fine</source>
        <translation>세밀</translation>
    </message>
    <message>
        <source>coarse</source>
        <translation>거침</translation>
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
        <source>Overlaps swapped</source>
        <translation>뒤바꾼 겹침</translation>
    </message>
    <message>
        <source>Overlaps of tubes, by their index in the report, at which the lower strand comes to the front: a knot becomes another one.</source>
        <translation>아래 가닥을 앞으로 가져올 튜브의 겹침(보고서의 번호): 매듭이 다른 매듭이 됩니다.</translation>
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
        <source>Quad Cage</source>
        <translation>쿼드 케이지</translation>
    </message>
    <message>
        <source>Turns drawn contours into a coarse control mesh of quads, whose subdivision surface is close to their solids.</source>
        <translation>그려진 윤곽선을 성긴 쿼드 제어 메쉬로 바꿉니다. 그 서브디비전 표면은 윤곽선의 솔리드에 가깝습니다.</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>링</translation>
    </message>
    <message>
        <source>Distance of the rings of quads that run around limbs.</source>
        <translation>팔다리를 감싸는 쿼드 링 사이의 거리입니다.</translation>
    </message>
    <message>
        <source>× the local radius</source>
        <translation>× 그 자리의 반지름</translation>
    </message>
    <message>
        <source>close</source>
        <translation>촘촘하게</translation>
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
        <source>sharp</source>
        <translation>각지게</translation>
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
        <source>no limit</source>
        <translation>제한 없음</translation>
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
        <source>Sharp over</source>
        <translation>날카로움 최소 각도</translation>
    </message>
    <message>
        <source>Edges without a tag become sharp where faces meet at more than this; 0 for none.</source>
        <translation>태그가 없는 에지는 페이스가 이보다 큰 각도로 만나면 날카로워집니다. 0이면 적용하지 않습니다.</translation>
    </message>
    <message>
        <source>Corners above</source>
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
        <source>unchanged</source>
        <translation>그대로</translation>
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
        <source>strict</source>
        <translation>엄격하게</translation>
    </message>
    <message>
        <source>loose</source>
        <translation>느슨하게</translation>
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
        <source>inwards</source>
        <translation>안쪽으로</translation>
    </message>
    <message>
        <source>outwards</source>
        <translation>바깥쪽으로</translation>
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
        <source>many</source>
        <translation>많게</translation>
    </message>
    <message>
        <source>few</source>
        <translation>적게</translation>
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
    <message>
        <source>stroke %1</source>
        <translation>획 %1</translation>
    </message>
    <message>
        <source>strokes %1</source>
        <translation>획 %1</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <translation>%1 그리기</translation>
    </message>
    <message>
        <source>Redraw %1</source>
        <translation>%1 다시 그리기</translation>
    </message>
    <message>
        <source>Erase %1</source>
        <translation>%1 지우기</translation>
    </message>
    <message>
        <source>Erase part of %1</source>
        <translation>%1 일부 지우기</translation>
    </message>
    <message>
        <source>Drag a point of %1</source>
        <translation>%1의 점 끌기</translation>
    </message>
    <message>
        <source>Bring %1 in front of %2</source>
        <translation>%1을(를) %2 앞으로 가져오기</translation>
    </message>
    <message>
        <source>Swap strands of %1</source>
        <translation>%1의 가닥 뒤바꾸기</translation>
    </message>
    <message>
        <source>Choose a reading</source>
        <translation>해석 선택</translation>
    </message>
    <message>
        <source>Find what %1 is</source>
        <translation>%1의 종류 자동 인식</translation>
    </message>
    <message>
        <source>Make %1 a %2</source>
        <translation>%1을(를) %2(으)로 지정</translation>
    </message>
    <message>
        <source>Set thickness of %1</source>
        <translation>%1의 두께 설정</translation>
    </message>
    <message>
        <source>Rename a part to %1</source>
        <translation>부위 이름을 %1(으)로 변경</translation>
    </message>
    <message>
        <source>Take the name off %1</source>
        <translation>%1의 이름 지우기</translation>
    </message>
    <message>
        <source>Make a far copy of %1</source>
        <translation>%1의 반대쪽 복사 만들기</translation>
    </message>
    <message>
        <source>Take away the far copy of %1</source>
        <translation>%1의 반대쪽 복사 없애기</translation>
    </message>
    <message>
        <source>Set colour of %1</source>
        <translation>%1의 색 지정</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>%1 대칭으로 만들기</translation>
    </message>
    <message>
        <source>End the symmetry of %1</source>
        <translation>%1의 대칭 끝내기</translation>
    </message>
    <message>
        <source>The copy of "%1" on the far side is left out, since it belongs to nothing: attach it to a part that isn't copied</source>
        <translation>"%1"의 반대쪽 복사는 붙어 있는 곳이 없어 만들지 않았습니다: 복사되지 않는 부위에 붙이세요</translation>
    </message>
    <message>
        <source>The copy of "%1" on the far side is left out, since it would cut through another part: draw it further away, or attach it</source>
        <translation>"%1"의 반대쪽 복사는 다른 부위와 겹치게 되어 만들지 않았습니다: 더 떨어뜨려 그리거나 붙이세요</translation>
    </message>
    <message>
        <source>contour</source>
        <translation>윤곽선</translation>
    </message>
    <message>
        <source>part</source>
        <translation>부위</translation>
    </message>
    <message>
        <source>blob</source>
        <translation>작은 형태</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>디테일</translation>
    </message>
    <message>
        <source>scribble</source>
        <translation>털, 해칭</translation>
    </message>
    <message>
        <source>tube</source>
        <translation>튜브</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>제외</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>숨은 선</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>보이는 선</translation>
    </message>
    <message>
        <source>Lay along x: %1</source>
        <translation>x축 방향으로 놓기: %1</translation>
    </message>
    <message>
        <source>Lay along y: %1</source>
        <translation>y축 방향으로 놓기: %1</translation>
    </message>
    <message>
        <source>Lay along z: %1</source>
        <translation>z축 방향으로 놓기: %1</translation>
    </message>
    <message>
        <source>Lay across x: %1</source>
        <translation>x축에 수직으로 놓기: %1</translation>
    </message>
    <message>
        <source>Lay across y: %1</source>
        <translation>y축에 수직으로 놓기: %1</translation>
    </message>
    <message>
        <source>Lay across z: %1</source>
        <translation>z축에 수직으로 놓기: %1</translation>
    </message>
    <message>
        <source>Make construction lines: %1</source>
        <translation>보조선으로 지정: %1</translation>
    </message>
    <message>
        <source>Make edges: %1</source>
        <translation>에지로 지정: %1</translation>
    </message>
    <message>
        <source>Link pieces by %1</source>
        <translation>%1(으)로 조각 연결</translation>
    </message>
    <message>
        <source>Unlink %1</source>
        <translation>%1 연결 해제</translation>
    </message>
    <message>
        <source>Lock the ends of %1</source>
        <translation>%1의 끝 고정</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 변경</translation>
    </message>
    <message>
        <source>Drag a vanishing point</source>
        <translation>소실점 끌기</translation>
    </message>
    <message>
        <source>Set the known point</source>
        <translation>좌표를 아는 점 설정</translation>
    </message>
    <message>
        <source>Forget the known point</source>
        <translation>좌표를 아는 점 해제</translation>
    </message>
    <message>
        <source>Set the length of stroke %1</source>
        <translation>획 %1의 길이 설정</translation>
    </message>
    <message>
        <source>Forget the length of stroke %1</source>
        <translation>획 %1의 길이 해제</translation>
    </message>
    <message>
        <source>Set the unit</source>
        <translation>단위 설정</translation>
    </message>
    <message>
        <source>Set the camera</source>
        <translation>카메라 설정</translation>
    </message>
    <message>
        <source>Set the sheet's size</source>
        <translation>용지 크기 설정</translation>
    </message>
    <message>
        <source>Keep an edge sharp</source>
        <translation>에지를 날카롭게 유지</translation>
    </message>
    <message>
        <source>Keep an edge sharp no longer</source>
        <translation>에지 날카로움 유지 해제</translation>
    </message>
    <message>
        <source>Leave a stroke out</source>
        <translation>획 제외</translation>
    </message>
    <message>
        <source>Leave a stroke out no longer</source>
        <translation>획 제외 해제</translation>
    </message>
    <message>
        <source>Choose a face</source>
        <translation>페이스 선택</translation>
    </message>
    <message>
        <source>Choose a face no longer</source>
        <translation>페이스 선택 해제</translation>
    </message>
    <message>
        <source>Choose faces</source>
        <translation>페이스 선택</translation>
    </message>
    <message>
        <source>node %1</source>
        <translation>노드 %1</translation>
    </message>
    <message>
        <source>curve %1</source>
        <translation>커브 %1</translation>
    </message>
    <message>
        <source>patch %1</source>
        <translation>패치 %1</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>점 %1</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>노드 %1개</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>요소 %1개</translation>
    </message>
    <message>
        <source>Draw inner %1</source>
        <translation>내부 %1 그리기</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>%1 설정</translation>
    </message>
    <message>
        <source>Turn round %1</source>
        <translation>%1 뒤집기</translation>
    </message>
    <message>
        <source>Split patch %1</source>
        <translation>패치 %1 분할</translation>
    </message>
    <message>
        <source>Split curve %1</source>
        <translation>커브 %1 분할</translation>
    </message>
    <message>
        <source>Bend curve %1</source>
        <translation>커브 %1 구부리기</translation>
    </message>
    <message>
        <source>Make smooth</source>
        <translation>매끄럽게 지정</translation>
    </message>
    <message>
        <source>Make crease</source>
        <translation>크리스로 지정</translation>
    </message>
    <message>
        <source>Automatic slope along %1</source>
        <translation>%1의 기울기 자동</translation>
    </message>
    <message>
        <source>Set slope along %1</source>
        <translation>%1의 기울기 설정</translation>
    </message>
    <message>
        <source>Set inner curve %1</source>
        <translation>내부 커브 %1 설정</translation>
    </message>
    <message>
        <source>Take curve %1 out of patch %2</source>
        <translation>패치 %2에서 커브 %1 빼기</translation>
    </message>
    <message>
        <source>Put curve %1 into patch %2</source>
        <translation>패치 %2에 커브 %1 넣기</translation>
    </message>
    <message>
        <source>Fill loop</source>
        <translation>루프 채우기</translation>
    </message>
    <message>
        <source>Merge patches at %1</source>
        <translation>%1에서 패치 병합</translation>
    </message>
    <message>
        <source>Add point to patch %1</source>
        <translation>패치 %1에 점 추가</translation>
    </message>
    <message>
        <source>Set radius of point %1</source>
        <translation>점 %1의 반지름 설정</translation>
    </message>
    <message>
        <source>Take curves</source>
        <translation>커브 가져오기</translation>
    </message>
    <message>
        <source>Curves of %1</source>
        <translation>%1의 커브</translation>
    </message>
    <message>
        <source>Select %1</source>
        <translation>%1 선택</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 이동</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>%1 회전</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>%1 크기 조절</translation>
    </message>
    <message>
        <source>Sharpen %1</source>
        <translation>%1 날카롭게</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>%1 스무스</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 삭제</translation>
    </message>
    <message>
        <source>Dissolve %1</source>
        <translation>%1 디졸브</translation>
    </message>
    <message>
        <source>Extrude %1</source>
        <translation>%1 돌출</translation>
    </message>
    <message>
        <source>Inset %1</source>
        <translation>%1 인셋</translation>
    </message>
    <message>
        <source>Loop cut %1</source>
        <translation>%1 루프 컷</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <translation>%1 고정</translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>%1 고정 해제</translation>
    </message>
    <message>
        <source>Cut a loop</source>
        <translation>루프 컷</translation>
    </message>
    <message>
        <source>Rename the set %1</source>
        <translation>세트 %1 이름 바꾸기</translation>
    </message>
    <message>
        <source>Sharpen the set %1</source>
        <translation>세트 %1 날카로움 변경</translation>
    </message>
    <message>
        <source>Merge the sets %1 and %2</source>
        <translation>세트 %1과(와) %2 병합</translation>
    </message>
    <message>
        <source>Remove the set %1</source>
        <translation>세트 %1 제거</translation>
    </message>
    <message>
        <source>Make the set %1</source>
        <translation>세트 %1 만들기</translation>
    </message>
    <message>
        <source>crease set %1</source>
        <translation>크리스 세트 %1</translation>
    </message>
    <message>
        <source>all vertices</source>
        <translation>모든 정점</translation>
    </message>
    <message>
        <source>all edges</source>
        <translation>모든 에지</translation>
    </message>
    <message>
        <source>all faces</source>
        <translation>모든 페이스</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>%1 배치</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 복제</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 이름 바꾸기</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 표시</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 숨기기</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>%1 그룹</translation>
    </message>
    <message>
        <source>Ungroup %1</source>
        <translation>%1 그룹 해제</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 열기</translation>
    </message>
    <message>
        <source>Add %1 to %2</source>
        <translation>%2에 %1 추가</translation>
    </message>
    <message>
        <source>Apply %1 to the new mesh</source>
        <translation>새 메쉬에 %1 적용</translation>
    </message>
    <message>
        <source>Switch on %1</source>
        <translation>%1 켜기</translation>
    </message>
    <message>
        <source>Switch off %1</source>
        <translation>%1 끄기</translation>
    </message>
    <message>
        <source>Keep the shape of %1</source>
        <translation>%1의 모양 유지</translation>
    </message>
    <message>
        <source>Keep the shape of faces</source>
        <translation>페이스의 모양 유지</translation>
    </message>
    <message>
        <source>Keep the outline of faces</source>
        <translation>페이스의 윤곽선 유지</translation>
    </message>
    <message>
        <source>Freeze %1</source>
        <translation>%1 프리즈</translation>
    </message>
    <message>
        <source>Scale %1 to the scene</source>
        <translation>%1을(를) 씬에 맞춰 크기 조절</translation>
    </message>
    <message>
        <source>%1 on</source>
        <translation>%1 켜기</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>%1 끄기</translation>
    </message>
    <message>
        <source>Add picture</source>
        <translation>밑그림 이미지 추가</translation>
    </message>
    <message>
        <source>Trace picture</source>
        <translation>밑그림 이미지 트레이스</translation>
    </message>
    <message>
        <source>State the camera</source>
        <translation>카메라 지정</translation>
    </message>
    <message>
        <source>Fit picture</source>
        <translation>밑그림 이미지 맞추기</translation>
    </message>
    <message>
        <source>Remove picture</source>
        <translation>밑그림 이미지 제거</translation>
    </message>
    <message>
        <source>Scale picture</source>
        <translation>밑그림 이미지 크기 조절</translation>
    </message>
    <message>
        <source>Move picture</source>
        <translation>밑그림 이미지 이동</translation>
    </message>
    <message>
        <source>Opacity of the picture</source>
        <translation>밑그림 이미지 불투명도</translation>
    </message>
    <message>
        <source>Add sketch</source>
        <translation>스케치 추가</translation>
    </message>
    <message>
        <source>hole %1</source>
        <translation>구멍 %1</translation>
    </message>
    <message>
        <source>holes %1</source>
        <translation>구멍 %1</translation>
    </message>
    <message>
        <source>Find holes of %1</source>
        <translation>%1의 구멍 찾기</translation>
    </message>
    <message>
        <source>Fill holes up to %1</source>
        <translation>%1 이하의 구멍 메우기</translation>
    </message>
    <message>
        <source>Method %1 of %2</source>
        <translation>%2의 방법 %1</translation>
    </message>
    <message>
        <source>Kernel %1 of %2</source>
        <translation>%2의 함수 %1</translation>
    </message>
    <message>
        <source>Bulge of %1</source>
        <translation>%1의 볼록함</translation>
    </message>
    <message>
        <source>Trim rim of %1</source>
        <translation>%1의 가장자리 다듬기</translation>
    </message>
    <message>
        <source>Fill %1</source>
        <translation>%1 메우기</translation>
    </message>
    <message>
        <source>Reopen %1</source>
        <translation>%1 다시 열기</translation>
    </message>
    <message>
        <source>Shape hole %1</source>
        <translation>구멍 %1 모양 조절</translation>
    </message>
    <message>
        <source>Fill all but the largest hole</source>
        <translation>가장 큰 구멍만 빼고 모두 메우기</translation>
    </message>
    <message>
        <source>Fill all inner holes</source>
        <translation>안쪽 구멍 모두 메우기</translation>
    </message>
    <message>
        <source>Reopen all holes</source>
        <translation>모든 구멍 다시 열기</translation>
    </message>
    <message>
        <source>Fill all holes</source>
        <translation>모든 구멍 메우기</translation>
    </message>
    <message>
        <source>Bridge holes %1 and %2</source>
        <translation>구멍 %1과(와) %2 브리지</translation>
    </message>
    <message>
        <source>Bridge %1</source>
        <translation>%1 브리지</translation>
    </message>
    <message>
        <source>Clear handles of %1</source>
        <translation>%1의 핸들 지우기</translation>
    </message>
    <message>
        <source>Preset %1 of all holes</source>
        <translation>모든 구멍의 프리셋 %1</translation>
    </message>
    <message>
        <source>Fill by patches</source>
        <translation>패치로 메우기</translation>
    </message>
    <message>
        <source>Remesh</source>
        <translation>리메쉬</translation>
    </message>
    <message>
        <source>%1 level %2</source>
        <translation>%1 레벨 %2</translation>
    </message>
    <message>
        <source>patch of hole %1</source>
        <translation>구멍 %1의 패치</translation>
    </message>
    <message>
        <source>patch of holes %1</source>
        <translation>구멍 %1의 패치</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>무한</translation>
    </message>
    <message>
        <source>Distance %1</source>
        <translation>거리 %1</translation>
    </message>
    <message>
        <source>Angle %1</source>
        <translation>각도 %1</translation>
    </message>
    <message>
        <source>Radius %1</source>
        <translation>반지름 %1</translation>
    </message>
    <message>
        <source>Distance: %1</source>
        <translation>거리: %1</translation>
    </message>
    <message>
        <source>Angle: %1</source>
        <translation>각도: %1</translation>
    </message>
    <message>
        <source>Radius: %1</source>
        <translation>반지름: %1</translation>
    </message>
    <message>
        <source>1 element</source>
        <translation>요소 1개</translation>
    </message>
    <message>
        <source>'%1' is no value for %2: it takes %3.</source>
        <translation>'%1'은(는) %2의 값이 될 수 없습니다. 가능한 값: %3.</translation>
    </message>
    <message>
        <source>There is no parameter '%1'.</source>
        <translation>'%1'(이)라는 매개변수가 없습니다.</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 또는 false</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>정수</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>%1에서 %2까지의 정수</translation>
    </message>
    <message>
        <source>a whole number of at least %1</source>
        <translation>%1 이상의 정수</translation>
    </message>
    <message>
        <source>a whole number of at most %1</source>
        <translation>%1 이하의 정수</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>숫자</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>%1에서 %2까지의 숫자</translation>
    </message>
    <message>
        <source>a number of at least %1, at most 1e30 in size</source>
        <translation>%1 이상이고 크기가 1e30 이하인 숫자</translation>
    </message>
    <message>
        <source>a number of at most %1, at most 1e30 in size</source>
        <translation>%1 이하이고 크기가 1e30 이하인 숫자</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>텍스트</translation>
    </message>
    <message>
        <source>a file name</source>
        <translation>파일 이름</translation>
    </message>
    <message>
        <source>one of %1 or %2</source>
        <translation>%1 또는 %2</translation>
    </message>
    <message>
        <source>three numbers, such as 0,0,1</source>
        <translation>숫자 세 개, 예: 0,0,1</translation>
    </message>
    <message>
        <source>isn't finite or is larger than 1e30</source>
        <translation>유한하지 않거나 1e30보다 큽니다</translation>
    </message>
    <message>
        <source>%1; %2 more are like it.</source>
        <translation>%1. 이런 항목이 %2개 더 있습니다.</translation>
    </message>
    <message>
        <source>A %1 has no id.</source>
        <translation>id가 없는 %1이(가) 있습니다.</translation>
    </message>
    <message>
        <source>A slope refers to a curve that isn't there.</source>
        <translation>기울기가 존재하지 않는 커브를 참조합니다.</translation>
    </message>
    <message>
        <source>The network has a tolerance that is not above 0.</source>
        <translation>네트워크의 허용 오차가 0보다 크지 않습니다.</translation>
    </message>
    <message>
        <source>%1 is there twice: give each %2 an id of its own.</source>
        <translation>%1이(가) 두 번 있습니다. %2마다 다른 id를 지정하세요.</translation>
    </message>
    <message>
        <source>%1 has a %2 that isn't finite or is larger than 1e30.</source>
        <translation>%1의 %2이(가) 유한하지 않거나 1e30보다 큽니다.</translation>
    </message>
    <message>
        <source>coordinate</source>
        <translation>좌표</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>노멀</translation>
    </message>
    <message>
        <source>fan place</source>
        <translation>팬 위치</translation>
    </message>
    <message>
        <source>slope of a magnitude</source>
        <translation>기울기 크기</translation>
    </message>
    <message>
        <source>%1 has a normal without length.</source>
        <translation>%1의 노멀에 길이가 없습니다.</translation>
    </message>
    <message>
        <source>%1 has a radius that is not above 0.</source>
        <translation>%1의 반지름이 0보다 크지 않습니다.</translation>
    </message>
    <message>
        <source>%1 refers to a curve that isn't there.</source>
        <translation>%1이(가) 존재하지 않는 커브를 참조합니다.</translation>
    </message>
    <message>
        <source>%1 ends at a node that isn't there.</source>
        <translation>%1이(가) 존재하지 않는 노드에서 끝납니다.</translation>
    </message>
    <message>
        <source>%1 has neither control points nor a node at both ends.</source>
        <translation>%1에 제어점도 없고 양 끝의 노드도 없습니다.</translation>
    </message>
    <message>
        <source>%1 has one control point: it needs two or more.</source>
        <translation>%1의 제어점이 하나뿐입니다. 두 개 이상 필요합니다.</translation>
    </message>
    <message>
        <source>%1 has curve "%2" twice in its loop.</source>
        <translation>%1의 루프에 커브 "%2"이(가) 두 번 있습니다.</translation>
    </message>
    <message>
        <source>%1 has a fullness that is not between -1 and 2.</source>
        <translation>%1의 볼륨감이 -1과 2 사이가 아닙니다.</translation>
    </message>
    <message>
        <source>%1 lies in a face that isn't there.</source>
        <translation>%1이(가) 존재하지 않는 페이스에 있습니다.</translation>
    </message>
    <message>
        <source>%1 has a fan place at a corner that its face's domain doesn't have.</source>
        <translation>%1의 팬 위치가 페이스 도메인에 없는 코너를 가리킵니다.</translation>
    </message>
    <message>
        <source>%1 has a slope for a face that isn't there.</source>
        <translation>%1에 존재하지 않는 페이스의 기울기가 있습니다.</translation>
    </message>
    <message>
        <source>%1 has a slope without one normal for each place.</source>
        <translation>%1의 기울기에 위치마다 노멀이 하나씩 있지 않습니다.</translation>
    </message>
    <message>
        <source>%1 has a slope whose places don't ascend from 0 to 1.</source>
        <translation>%1의 기울기 위치가 0에서 1로 커지는 순서가 아닙니다.</translation>
    </message>
    <message>
        <source>Node "%1"</source>
        <translation>노드 "%1"</translation>
    </message>
    <message>
        <source>Curve "%1"</source>
        <translation>커브 "%1"</translation>
    </message>
    <message>
        <source>Face "%1"</source>
        <translation>페이스 "%1"</translation>
    </message>
    <message>
        <source>Point "%1"</source>
        <translation>점 "%1"</translation>
    </message>
    <message>
        <source>node "%1"</source>
        <translation>노드 "%1"</translation>
    </message>
    <message>
        <source>curve "%1"</source>
        <translation>커브 "%1"</translation>
    </message>
    <message>
        <source>face "%1"</source>
        <translation>페이스 "%1"</translation>
    </message>
    <message>
        <source>point "%1"</source>
        <translation>점 "%1"</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>커브</translation>
    </message>
    <message>
        <source>node</source>
        <translation>노드</translation>
    </message>
    <message>
        <source>%1 offsets don't begin with 0.</source>
        <translation>%1 오프셋이 0으로 시작하지 않습니다.</translation>
    </message>
    <message>
        <source>%1 offsets descend at number %2.</source>
        <translation>%1 오프셋이 %2번째에서 작아집니다.</translation>
    </message>
    <message>
        <source>%1 offsets end at %2 but %3 vertex indices are given.</source>
        <translation>%1 오프셋은 %2에서 끝나는데 정점 인덱스는 %3개입니다.</translation>
    </message>
    <message>
        <source>Face %1 uses vertex %2 of a mesh with %3 vertices.</source>
        <translation>페이스 %1이(가) 정점이 %3개인 메쉬에서 정점 %2을(를) 사용합니다.</translation>
    </message>
    <message>
        <source>Line %1 uses vertex %2 of a mesh with %3 vertices.</source>
        <translation>선 %1이(가) 정점이 %3개인 메쉬에서 정점 %2을(를) 사용합니다.</translation>
    </message>
    <message>
        <source>Vertex %1 has a coordinate that isn't finite or is larger than 1e30.</source>
        <translation>정점 %1의 좌표가 유한하지 않거나 1e30보다 큽니다.</translation>
    </message>
    <message>
        <source>Face %1 has fewer than 3 corners.</source>
        <translation>페이스 %1의 꼭짓점이 3개보다 적습니다.</translation>
    </message>
    <message>
        <source>Face %1 uses vertex %2 more than once.</source>
        <translation>페이스 %1이(가) 정점 %2을(를) 두 번 이상 사용합니다.</translation>
    </message>
    <message>
        <source>Attribute '%1' has %2 values of width %3 instead of %4.</source>
        <translation>속성 '%1'에 너비 %3의 값이 %4개가 아니라 %2개 있습니다.</translation>
    </message>
    <message>
        <source>The %1 of point %2 isn't finite or is larger than 1e30: correct or remove it.</source>
        <translation>점 %2의 %1이(가) 유한하지 않거나 1e30보다 큽니다. 고치거나 제거하세요.</translation>
    </message>
    <message>
        <source>The value of point %1 isn't finite or is larger than 1e30: correct or remove it.</source>
        <translation>점 %1의 값이 유한하지 않거나 1e30보다 큽니다. 고치거나 제거하세요.</translation>
    </message>
    <message>
        <source>There is no point to fit a surface to: give at least one.</source>
        <translation>서피스를 맞출 점이 없습니다. 하나 이상 지정하세요.</translation>
    </message>
    <message>
        <source>Parameter '%1' can't be used: %2.</source>
        <translation>매개변수 '%1'을(를) 사용할 수 없습니다: %2.</translation>
    </message>
    <message>
        <source>Face %1 has %2 corners, where triangles are needed: triangulate the mesh.</source>
        <translation>페이스 %1의 꼭짓점이 %2개인데 삼각형이 필요합니다. 메쉬를 삼각형으로 나누세요.</translation>
    </message>
    <message>
        <source>"%1" crosses itself: its two sides are read as lying beside one another there</source>
        <translation>"%1"이(가) 자기 자신과 교차합니다. 그곳에서는 두 면이 나란히 놓인 것으로 인식했습니다</translation>
    </message>
    <message>
        <source>"%1" is no line of a solid and was left out</source>
        <translation>"%1"은(는) 솔리드의 선이 아니어서 제외했습니다</translation>
    </message>
    <message>
        <source>"%1" was drawn over "%2": they are read as one line</source>
        <translation>"%1"이(가) "%2" 위에 겹쳐 그려져 하나의 선으로 인식했습니다</translation>
    </message>
    <message>
        <source>All lines of the drawing are set to be ignored: give the outline of something another kind</source>
        <translation>드로잉의 모든 선이 제외로 설정되어 있습니다. 윤곽선이 될 선의 종류를 바꾸세요</translation>
    </message>
    <message>
        <source>"%1" can't be a %2: let its ends meet something, or give it another kind</source>
        <translation>"%1"은(는) %2이(가) 될 수 없습니다. 끝을 다른 것에 닿게 하거나 종류를 바꾸세요</translation>
    </message>
    <message>
        <source>The drawing's lines enclose nothing: draw the outline of something</source>
        <translation>드로잉의 선이 아무것도 둘러싸지 않습니다. 윤곽선을 그리세요</translation>
    </message>
    <message>
        <source>Contours meet in one point or overlap (%1): move one of them a little</source>
        <translation>윤곽선이 한 점에서 만나거나 겹칩니다(%1). 그중 하나를 조금 옮기세요</translation>
    </message>
    <message>
        <source>hidden lines</source>
        <translation>숨은 선</translation>
    </message>
    <message>
        <source>No solid looks like this: %1; check what passes behind what there</source>
        <translation>이렇게 보이는 솔리드가 없습니다: %1. 무엇이 무엇의 뒤로 지나가는지 확인하세요</translation>
    </message>
    <message>
        <source>all of "%1" would be covered</source>
        <translation>"%1" 전체가 가려지게 됩니다</translation>
    </message>
    <message>
        <source>the hidden ends can't all be connected in pairs</source>
        <translation>숨은 끝을 모두 쌍으로 연결할 수 없습니다</translation>
    </message>
    <message>
        <source>nothing comes out again that the hidden end of %1 could be connected to</source>
        <translation>%1의 숨은 끝과 연결할 수 있는 선이 다시 나타나지 않습니다</translation>
    </message>
    <message>
        <source>the drawn part of "%1" would be covered</source>
        <translation>"%1"의 그려진 부분이 가려지게 됩니다</translation>
    </message>
    <message>
        <source>the hidden part of "%1" would lie in the open</source>
        <translation>"%1"의 숨은 부분이 드러나게 됩니다</translation>
    </message>
    <message>
        <source>"%1" and "%2" contradict one another</source>
        <translation>"%1"과(와) "%2"이(가) 서로 모순됩니다</translation>
    </message>
    <message>
        <source>"%1" would be the edge of nothing</source>
        <translation>"%1"이(가) 아무것의 경계도 되지 않습니다</translation>
    </message>
    <message>
        <source>the lines that stop at others contradict one another</source>
        <translation>다른 선에서 멈추는 선들이 서로 모순됩니다</translation>
    </message>
    <message>
        <source>%1, and %2</source>
        <translation>%1. 그리고 %2</translation>
    </message>
    <message>
        <source>"%1" lies within "%2" and was read as a hole: mark it as a part if it lies in front</source>
        <translation>"%1"이(가) "%2" 안에 있어 구멍으로 인식했습니다. 앞에 있는 것이라면 부위로 지정하세요</translation>
    </message>
    <message>
        <source>"%1" lies within "%2" and was read as a part in front: mark it as a hole if it is one</source>
        <translation>"%1"이(가) "%2" 안에 있어 앞쪽 부위로 인식했습니다. 구멍이라면 구멍으로 지정하세요</translation>
    </message>
    <message>
        <source>The attached objects "%1" and "%2" need a depth from 0 to 1</source>
        <translation>결합된 오브젝트 "%1"과(와) "%2"의 깊이는 0에서 1 사이여야 합니다</translation>
    </message>
    <message>
        <source>The seam of "%1" and "%2" needs a radius from 0 to 1</source>
        <translation>"%1"과(와) "%2"의 이음매 반지름은 0에서 1 사이여야 합니다</translation>
    </message>
    <message>
        <source>There is no object "%1" to attach: use the name of an object or stroke</source>
        <translation>결합할 오브젝트 "%1"이(가) 없습니다. 오브젝트나 획의 이름을 사용하세요</translation>
    </message>
    <message>
        <source>"%1" and "%2" are one object: attach two different ones</source>
        <translation>"%1"과(와) "%2"은(는) 같은 오브젝트입니다. 서로 다른 두 오브젝트를 결합하세요</translation>
    </message>
    <message>
        <source>The objects "%1" and "%2" can't be attached: %3</source>
        <translation>오브젝트 "%1"과(와) "%2"을(를) 결합할 수 없습니다: %3</translation>
    </message>
    <message>
        <source>the lines of "%1" make no solid yet</source>
        <translation>"%1"의 선이 아직 솔리드를 이루지 않습니다</translation>
    </message>
    <message>
        <source>they don't overlap in the drawing</source>
        <translation>드로잉에서 서로 겹치지 않습니다</translation>
    </message>
    <message>
        <source>The object "%1" has %2 "%3": give a number from 0.001 to 1</source>
        <translation>오브젝트 "%1"의 %2 값이 "%3"입니다. 0.001에서 1 사이의 숫자를 지정하세요</translation>
    </message>
    <message>
        <source>The object "%1" has %2 "%3": give a number from 0.05 to 4</source>
        <translation>오브젝트 "%1"의 %2 값이 "%3"입니다. 0.05에서 4 사이의 숫자를 지정하세요</translation>
    </message>
    <message>
        <source>The attached objects "%1" and "%2" could not be joined, since their surfaces don't meet, and were kept apart: let them sink deeper, or draw them further over one another</source>
        <translation>결합할 오브젝트 "%1"과(와) "%2"의 서피스가 만나지 않아 분리해 두었습니다. 더 깊이 파묻히게 하거나 더 많이 겹치게 그리세요</translation>
    </message>
    <message>
        <source>The attached objects "%1" and "%2" could not be joined, since no depth holds them together, and were kept apart: attach fewer parts, or draw thin ones wider</source>
        <translation>결합할 오브젝트 "%1"과(와) "%2"을(를) 붙여 둘 깊이가 없어 분리해 두었습니다. 결합하는 부위를 줄이거나 얇은 부위를 더 넓게 그리세요</translation>
    </message>
    <message>
        <source>The attached objects "%1" and "%2" could not be joined to one sound surface and were kept apart: change how deep they sink, or draw them further over one another</source>
        <translation>결합할 오브젝트 "%1"과(와) "%2"을(를) 올바른 하나의 서피스로 합칠 수 없어 분리해 두었습니다. 파묻히는 깊이를 바꾸거나 더 많이 겹치게 그리세요</translation>
    </message>
    <message>
        <source>The depth of "%1" could not be worked out exactly enough: draw its thin parts wider, or its lines further apart</source>
        <translation>"%1"의 깊이를 충분히 정확하게 구할 수 없습니다. 얇은 부분을 더 넓게 그리거나 선 사이를 더 띄우세요</translation>
    </message>
    <message>
        <source>The depth found for "%1" is more than the widths of what lies over what explain: raise the weight of distance, or draw fewer parts over one another</source>
        <translation>"%1"의 깊이가 겹친 부위의 너비에 비해 지나치게 깊습니다. 거리 가중치를 높이거나 겹치는 부위를 줄이세요</translation>
    </message>
    <message>
        <source>The surface of "%1" %2: draw its lines further apart, or lower the resolution step</source>
        <translation>"%1"의 서피스 오류: %2. 선 사이를 더 띄워 그리거나 해상도 간격을 줄이세요</translation>
    </message>
    <message>
        <source>intersects another one</source>
        <translation>다른 서피스와 교차합니다</translation>
    </message>
    <message>
        <source>intersects itself or another one</source>
        <translation>자기 자신이나 다른 서피스와 교차합니다</translation>
    </message>
    <message>
        <source>is not closed</source>
        <translation>닫혀 있지 않습니다</translation>
    </message>
    <message>
        <source>is not a manifold</source>
        <translation>매니폴드가 아닙니다</translation>
    </message>
    <message>
        <source>is not oriented outwards</source>
        <translation>바깥쪽을 향하지 않습니다</translation>
    </message>
    <message>
        <source>has faces without area</source>
        <translation>면적이 없는 페이스가 있습니다</translation>
    </message>
    <message>
        <source>has Euler number %1 where the drawing has %2</source>
        <translation>오일러 수가 %1인데 드로잉에서는 %2입니다</translation>
    </message>
    <message>
        <source>Closed a gap of %1 between the ends of "%2"</source>
        <translation>"%2"의 양 끝 사이 간격 %1을(를) 닫았습니다</translation>
    </message>
    <message>
        <source>Closed a gap of %1 between "%2" and "%3"</source>
        <translation>"%2"과(와) "%3" 사이의 간격 %1을(를) 닫았습니다</translation>
    </message>
    <message>
        <source>Two parts that lie over one another are nearer than the minimum gap: draw them thinner, further apart, or reduce the minimum gap</source>
        <translation>겹쳐 있는 두 부위가 최소 간격보다 가깝습니다. 더 얇게 그리거나 더 띄우거나 최소 간격을 줄이세요</translation>
    </message>
    <message>
        <source>The solid would use only %1 % of what is drawn and lack "%2", the largest line that is left out: close that line, lead its ends to the lines that they pass behind, or delete it</source>
        <translation>솔리드가 그린 선의 %1 %만 사용하고, 제외되는 가장 큰 선인 "%2"이(가) 빠지게 됩니다. 그 선을 닫거나, 뒤로 지나가는 선까지 끝을 잇거나, 선을 삭제하세요</translation>
    </message>
    <message>
        <source>The drawing has no closed outline: draw at least one</source>
        <translation>드로잉에 닫힌 윤곽선이 없습니다. 하나 이상 그리세요</translation>
    </message>
    <message>
        <source>"%1" stays a line: the solid is too thin or too steep there; draw it farther inside</source>
        <translation>"%1"은(는) 선으로 남습니다. 그곳의 솔리드가 너무 얇거나 가파릅니다. 더 안쪽에 그리세요</translation>
    </message>
    <message>
        <source>The stroke "%1" is too short and was ignored</source>
        <translation>획 "%1"이(가) 너무 짧아 무시했습니다</translation>
    </message>
    <message>
        <source>The hidden stroke "%1" is closed: draw it from where a line passes behind something to where it comes out</source>
        <translation>숨은 획 "%1"이(가) 닫혀 있습니다. 선이 무언가의 뒤로 들어가는 곳에서 나오는 곳까지 그리세요</translation>
    </message>
    <message>
        <source>The hidden stroke "%1" begins or ends where no line does that it could go on from: draw it up to one</source>
        <translation>숨은 획 "%1"의 시작이나 끝에 이어질 선이 없습니다. 선이 있는 곳까지 그리세요</translation>
    </message>
    <message>
        <source>lines pass behind "%1" on both of its sides, of which only one can be its surface</source>
        <translation>선들이 "%1"의 양쪽에서 뒤로 지나가는데, 한쪽만 그 서피스일 수 있습니다</translation>
    </message>
    <message>
        <source>"%1" crosses itself in full view: which part is in front? Let the other one stop where it passes behind</source>
        <translation>"%1"이(가) 보이는 곳에서 자기 자신과 교차합니다. 어느 부분이 앞입니까? 뒤로 지나가는 부분은 그곳에서 멈추게 그리세요</translation>
    </message>
    <message>
        <source>"%1" and "%2" cross in full view: which one is in front? Let the other one stop where it passes behind</source>
        <translation>"%1"과(와) "%2"이(가) 보이는 곳에서 교차합니다. 어느 쪽이 앞입니까? 뒤로 지나가는 선은 그곳에서 멈추게 그리세요</translation>
    </message>
    <message>
        <source>"%1" touches itself: draw the two parts apart</source>
        <translation>"%1"이(가) 자기 자신에 닿습니다. 두 부분을 띄워 그리세요</translation>
    </message>
    <message>
        <source>"%1" and "%2" touch: draw them apart, or let one end at the other</source>
        <translation>"%1"과(와) "%2"이(가) 닿습니다. 띄워 그리거나 한쪽이 다른 쪽에서 끝나게 하세요</translation>
    </message>
    <message>
        <source>the end of "%1" touches nothing that it could pass behind</source>
        <translation>"%1"의 끝이 그 뒤로 지나갈 수 있는 것에 닿지 않습니다</translation>
    </message>
    <message>
        <source>The stroke "%1" is set to lie behind itself: write the id of another stroke</source>
        <translation>획 "%1"이(가) 자기 자신의 뒤에 있도록 설정되어 있습니다. 다른 획의 id를 지정하세요</translation>
    </message>
    <message>
        <source>The stroke "%1" is set to lie behind "%2", which isn't in the drawing: write the id of another stroke</source>
        <translation>획 "%1"이(가) 드로잉에 없는 "%2"의 뒤에 있도록 설정되어 있습니다. 다른 획의 id를 지정하세요</translation>
    </message>
    <message>
        <source>The stroke "%1" is marked as "%2", which is no kind of stroke: write contour, part, hole, blob, detail, scribble, tube, ignored, hidden or visible</source>
        <translation>획 "%1"에 지정된 "%2"은(는) 획의 종류가 아닙니다. contour, part, hole, blob, detail, scribble, tube, ignored, hidden, visible 중 하나를 쓰세요</translation>
    </message>
    <message>
        <source>The stroke "%1" has a coordinate that isn't finite or is larger than 1e30: correct it or remove the stroke</source>
        <translation>획 "%1"의 좌표가 유한하지 않거나 1e30보다 큽니다. 고치거나 획을 제거하세요</translation>
    </message>
    <message>
        <source>The drawing has no stroke to work with: draw the outline of something</source>
        <translation>드로잉에 사용할 획이 없습니다. 윤곽선을 그리세요</translation>
    </message>
    <message>
        <source>The strokes are too long in all for their size, the longest being "%1": remove scribbles</source>
        <translation>획이 크기에 비해 전체적으로 너무 깁니다. 가장 긴 획은 "%1"입니다. 낙서를 제거하세요</translation>
    </message>
    <message>
        <source>"%1" and "%2" cross in full view: "%3" is read as the one in front; as it is set</source>
        <translation>"%1"과(와) "%2"이(가) 보이는 곳에서 교차합니다. 설정대로 "%3"을(를) 앞에 있는 것으로 인식했습니다</translation>
    </message>
    <message>
        <source>"%1" and "%2" cross in full view: "%3" is read as the one in front; if it lies behind, let it stop at the other one</source>
        <translation>"%1"과(와) "%2"이(가) 보이는 곳에서 교차합니다. "%3"을(를) 앞에 있는 것으로 인식했습니다. 뒤에 있는 것이라면 다른 선에서 멈추게 그리세요</translation>
    </message>
    <message>
        <source>The loop of face "%1" is open between curves "%2" and "%3", whose ends are %4 apart (tolerance %5): walk along curve "%6" the other way (change its sign).</source>
        <translation>페이스 "%1"의 루프가 커브 "%2"과(와) "%3" 사이에서 열려 있습니다. 두 끝의 거리는 %4입니다(허용 오차 %5). 커브 "%6"의 방향을 반대로 하세요(부호 변경).</translation>
    </message>
    <message>
        <source>The loop of face "%1" is open between curves "%2" and "%3", whose ends are %4 apart (tolerance %5): move the ends together, or add the curve that is missing.</source>
        <translation>페이스 "%1"의 루프가 커브 "%2"과(와) "%3" 사이에서 열려 있습니다. 두 끝의 거리는 %4입니다(허용 오차 %5). 끝을 맞추거나 빠진 커브를 추가하세요.</translation>
    </message>
    <message>
        <source>Face "%1" has no curve, and a surface needs 2 at least: add the curves that close its loop.</source>
        <translation>페이스 "%1"에 커브가 없습니다. 서피스에는 2개 이상 필요합니다. 루프를 닫는 커브를 추가하세요.</translation>
    </message>
    <message>
        <source>Face "%1" has one curve only, and a surface needs 2 at least: add the curves that close its loop.</source>
        <translation>페이스 "%1"에 커브가 하나뿐입니다. 서피스에는 2개 이상 필요합니다. 루프를 닫는 커브를 추가하세요.</translation>
    </message>
    <message>
        <source>Face "%1" has one curve only, and a surface needs 2 at least: split it, best in 4.</source>
        <translation>페이스 "%1"에 커브가 하나뿐입니다. 서피스에는 2개 이상 필요합니다. 되도록 4개로 분할하세요.</translation>
    </message>
    <message>
        <source>Face "%1" has %2 curves, and a surface can have %3: split the face, or join curves.</source>
        <translation>페이스 "%1"의 커브가 %2개인데 서피스는 %3개까지 가질 수 있습니다. 페이스를 분할하거나 커브를 합치세요.</translation>
    </message>
    <message>
        <source>Face "%1" has %2 curves: above %3 surfaces become flat in the middle; split the face where it matters.</source>
        <translation>페이스 "%1"의 커브가 %2개입니다. %3개가 넘으면 서피스 가운데가 평평해집니다. 중요한 곳에서 페이스를 분할하세요.</translation>
    </message>
    <message>
        <source>The faces "%1" and "%2" can't both be turned to one side of the surface along curve "%3", as on a Moebius strip: their normals differ there.</source>
        <translation>뫼비우스 띠처럼 페이스 "%1"과(와) "%2"을(를) 커브 "%3"에서 서피스의 같은 쪽으로 향하게 할 수 없습니다. 그곳의 노멀이 서로 다릅니다.</translation>
    </message>
    <message>
        <source>One curve of face "%1" is nearly as long as the others together, so its domain was evened out (beta %2): the surface is fine, its parameters are stretched there.</source>
        <translation>페이스 "%1"의 한 커브가 나머지를 합친 것만큼 길어 도메인을 고르게 조정했습니다(베타 %2). 서피스는 정상이며 그곳의 매개변수만 늘어나 있습니다.</translation>
    </message>
    <message>
        <source>Face "%1" is folded over at %2 % of its places: split it by a curve where its loop turns inwards or crosses itself.</source>
        <translation>페이스 "%1"의 %2 %가 접혀 있습니다. 루프가 안쪽으로 꺾이거나 자기 자신과 교차하는 곳을 커브로 분할하세요.</translation>
    </message>
    <message>
        <source>The drawing has no stroke that is long enough to become a curve.</source>
        <translation>드로잉에 커브가 될 만큼 긴 획이 없습니다.</translation>
    </message>
    <message>
        <source>Stroke %1 is left out: it is no longer than the tolerance of curves; draw it longer, or delete it.</source>
        <translation>획 %1이(가) 커브의 허용 오차보다 짧아 제외했습니다. 더 길게 그리거나 삭제하세요.</translation>
    </message>
    <message>
        <source>No edge of the mesh is chosen: name some, or choose others by select and angle.</source>
        <translation>선택된 메쉬 에지가 없습니다. 에지를 지정하거나 선택 방식과 각도를 바꾸세요.</translation>
    </message>
    <message>
        <source>it has fewer than 3 edges</source>
        <translation>에지가 3개보다 적습니다</translation>
    </message>
    <message>
        <source>the faces along its rim don't agree in direction</source>
        <translation>가장자리를 따라 페이스의 방향이 서로 맞지 않습니다</translation>
    </message>
    <message>
        <source>two vertices of its rim are at one place</source>
        <translation>가장자리의 두 정점이 같은 위치에 있습니다</translation>
    </message>
    <message>
        <source>faces along its rim have no area</source>
        <translation>가장자리의 페이스에 면적이 없습니다</translation>
    </message>
    <message>
        <source>its rim has edges too short beside the others</source>
        <translation>가장자리에 다른 에지에 비해 너무 짧은 에지가 있습니다</translation>
    </message>
    <message>
        <source>its patch would cut through itself or the mesh</source>
        <translation>패치가 자기 자신이나 메쉬를 뚫고 지나가게 됩니다</translation>
    </message>
    <message>
        <source>A curve needs two control points or more.</source>
        <translation>커브에는 제어점이 두 개 이상 필요합니다.</translation>
    </message>
    <message>
        <source>A curve without nodes needs control points.</source>
        <translation>노드가 없는 커브에는 제어점이 필요합니다.</translation>
    </message>
    <message>
        <source>A straight curve needs a node at both ends.</source>
        <translation>직선 커브에는 양 끝에 노드가 필요합니다.</translation>
    </message>
    <message>
        <source>Curve "%1" has no control point %2.</source>
        <translation>커브 "%1"에 제어점 %2이(가) 없습니다.</translation>
    </message>
    <message>
        <source>Curve "%1" can only be split between its ends.</source>
        <translation>커브 "%1"은(는) 양 끝 사이에서만 분할할 수 있습니다.</translation>
    </message>
    <message>
        <source>A slope's magnitude must be finite.</source>
        <translation>기울기의 크기는 유한해야 합니다.</translation>
    </message>
    <message>
        <source>The slope along curve "%1" is found automatically: give it a normal first.</source>
        <translation>커브 "%1"의 기울기는 자동으로 정해집니다. 먼저 노멀을 지정하세요.</translation>
    </message>
    <message>
        <source>A place or way has a coordinate that isn't finite or is larger than 1e30.</source>
        <translation>위치나 이동량의 좌표가 유한하지 않거나 1e30보다 큽니다.</translation>
    </message>
    <message>
        <source>A normal has no length: give one that points somewhere.</source>
        <translation>노멀에 길이가 없습니다. 방향이 있는 노멀을 지정하세요.</translation>
    </message>
    <message>
        <source>A radius must be above 0.</source>
        <translation>반지름은 0보다 커야 합니다.</translation>
    </message>
    <message>
        <source>A place along a curve must be a fraction from 0 to 1.</source>
        <translation>커브 위의 위치는 0에서 1 사이의 비율이어야 합니다.</translation>
    </message>
    <message>
        <source>The fullness of a face must be between -1 and 2.</source>
        <translation>페이스의 볼륨감은 -1과 2 사이여야 합니다.</translation>
    </message>
    <message>
        <source>A face needs curves around it.</source>
        <translation>페이스에는 둘레를 이루는 커브가 필요합니다.</translation>
    </message>
    <message>
        <source>A loop has a curve that isn't there.</source>
        <translation>루프에 존재하지 않는 커브가 있습니다.</translation>
    </message>
    <message>
        <source>Curve "%1" can be in a loop only once.</source>
        <translation>커브 "%1"은(는) 루프에 한 번만 있을 수 있습니다.</translation>
    </message>
    <message>
        <source>A fan place must be finite.</source>
        <translation>팬 위치는 유한해야 합니다.</translation>
    </message>
    <message>
        <source>Face "%1" has no corner %2 in its domain.</source>
        <translation>페이스 "%1"의 도메인에 코너 %2이(가) 없습니다.</translation>
    </message>
    <message>
        <source>The inner curve isn't in the network.</source>
        <translation>내부 커브가 네트워크에 없습니다.</translation>
    </message>
    <message>
        <source>Face "%1" has curve "%2" already: choose another one.</source>
        <translation>페이스 "%1"에 이미 커브 "%2"이(가) 있습니다. 다른 커브를 선택하세요.</translation>
    </message>
    <message>
        <source>Curve "%1" isn't all that two faces share: choose a curve between exactly two faces.</source>
        <translation>커브 "%1" 하나만으로 두 페이스가 맞닿아 있지 않습니다. 정확히 두 페이스 사이에 있는 커브를 선택하세요.</translation>
    </message>
    <message>
        <source>Curve "%1" ends %2 away from the loop of face "%3": bring its ends to the loop.</source>
        <translation>커브 "%1"의 끝이 페이스 "%3"의 루프에서 %2만큼 떨어져 있습니다. 끝을 루프에 맞추세요.</translation>
    </message>
    <message>
        <source>Curve "%1" is a side of face "%2": choose one across it.</source>
        <translation>커브 "%1"은(는) 페이스 "%2"의 변입니다. 페이스를 가로지르는 커브를 선택하세요.</translation>
    </message>
    <message>
        <source>Curve "%1" begins and ends at the same place of face "%2": draw it from one place of the loop to another.</source>
        <translation>커브 "%1"이(가) 페이스 "%2"의 같은 곳에서 시작하고 끝납니다. 루프의 한 곳에서 다른 곳까지 그리세요.</translation>
    </message>
    <message>
        <source>A curve is named twice: a loop has each of its curves once.</source>
        <translation>같은 커브가 두 번 지정되었습니다. 루프에는 각 커브가 한 번씩만 있습니다.</translation>
    </message>
    <message>
        <source>A loop of %1 curves has more than 64: leave some out.</source>
        <translation>루프의 커브가 %1개로 64개를 넘습니다. 일부를 빼세요.</translation>
    </message>
    <message>
        <source>No curve is chosen: choose those around a patch.</source>
        <translation>선택된 커브가 없습니다. 패치 둘레의 커브를 선택하세요.</translation>
    </message>
    <message>
        <source>Curve "%1" isn't closed: choose all curves around a patch.</source>
        <translation>커브 "%1"이(가) 닫혀 있지 않습니다. 패치 둘레의 커브를 모두 선택하세요.</translation>
    </message>
    <message>
        <source>Curves %1 all meet at one place: leave out those that aren't around the patch.</source>
        <translation>커브 %1이(가) 모두 한 곳에서 만납니다. 패치 둘레가 아닌 커브를 빼세요.</translation>
    </message>
    <message>
        <source>Both ends of curve "%1" are %2 apart: move their ends together, or choose the curve between them.</source>
        <translation>커브 "%1"의 양 끝이 %2만큼 떨어져 있습니다. 끝을 맞추거나 그 사이의 커브를 선택하세요.</translation>
    </message>
    <message>
        <source>Curves "%1" and "%2" are %3 apart: move their ends together, or choose the curve between them.</source>
        <translation>커브 "%1"과(와) "%2"이(가) %3만큼 떨어져 있습니다. 끝을 맞추거나 그 사이의 커브를 선택하세요.</translation>
    </message>
    <message>
        <source>The curves are more than one loop: choose those of the loop with curve "%1" or those of the loop with curve "%2".</source>
        <translation>커브들이 루프 하나가 아닙니다. 커브 "%1"이(가) 있는 루프나 커브 "%2"이(가) 있는 루프의 커브만 선택하세요.</translation>
    </message>
    <message>
        <source>The network has no %1 "%2": name one of its own.</source>
        <translation>네트워크에 %1 "%2"이(가) 없습니다. 네트워크에 있는 것을 지정하세요.</translation>
    </message>
    <message>
        <source>Curve "%1" crosses the mirror plane, and so does its image: split it there and delete one part to have one side mirrored alone.</source>
        <translation>커브 "%1"이(가) 미러 평면을 가로지르고 미러된 커브도 그렇습니다. 한쪽만 미러하려면 그곳에서 분할하고 한 부분을 삭제하세요.</translation>
    </message>
    <message>
        <source>Curve "%1" belongs to %2 faces: it can't be smooth there, and the mesh has a non-manifold edge.</source>
        <translation>커브 "%1"이(가) 페이스 %2개에 속합니다. 그곳은 매끄러울 수 없고 메쉬에 비매니폴드 에지가 생깁니다.</translation>
    </message>
    <message>
        <source>The faces %1 meet at node "%2" like the sides of a knife, so they have no common normal there: along the smooth curve "%3" it is taken from elsewhere on the curve; make that curve a crease where this is an edge.</source>
        <translation>페이스 %1이(가) 노드 "%2"에서 칼날처럼 만나 공통 노멀이 없습니다. 스무스 커브 "%3"에서는 커브의 다른 곳에서 노멀을 가져옵니다. 날이 선 곳이라면 그 커브를 크리스로 바꾸세요.</translation>
    </message>
    <message>
        <source>The normal at %1 of curve "%2" points along the curve, so it gives no slope and is left out: turn it away from the curve.</source>
        <translation>커브 "%2"의 %1 위치에 있는 노멀이 커브 방향을 향해 기울기를 정할 수 없어 제외했습니다. 커브에서 벗어난 방향으로 돌리세요.</translation>
    </message>
    <message>
        <source>The start of curve "%1" is %2 away from its node, more than the tolerance of %3: move it there, or raise the tolerance.</source>
        <translation>커브 "%1"의 시작점이 노드에서 %2만큼 떨어져 허용 오차 %3을(를) 넘습니다. 노드로 옮기거나 허용 오차를 늘리세요.</translation>
    </message>
    <message>
        <source>The end of curve "%1" is %2 away from its node, more than the tolerance of %3: move it there, or raise the tolerance.</source>
        <translation>커브 "%1"의 끝점이 노드에서 %2만큼 떨어져 허용 오차 %3을(를) 넘습니다. 노드로 옮기거나 허용 오차를 늘리세요.</translation>
    </message>
    <message>
        <source>The start of curve "%1" was moved by %2 to where it meets the others.</source>
        <translation>커브 "%1"의 시작점을 다른 커브와 만나는 곳으로 %2만큼 옮겼습니다.</translation>
    </message>
    <message>
        <source>The end of curve "%1" was moved by %2 to where it meets the others.</source>
        <translation>커브 "%1"의 끝점을 다른 커브와 만나는 곳으로 %2만큼 옮겼습니다.</translation>
    </message>
    <message>
        <source>Curve "%1" is only %2 long, not more than the tolerance: delete it, or move its ends apart.</source>
        <translation>커브 "%1"의 길이가 %2로 허용 오차를 넘지 않습니다. 삭제하거나 양 끝을 벌리세요.</translation>
    </message>
    <message>
        <source>Point "%1" is left out, since it lies on the same place of face "%2" as point "%3": delete one of them, or place one elsewhere.</source>
        <translation>점 "%1"이(가) 페이스 "%2"에서 점 "%3"과(와) 같은 위치에 있어 제외했습니다. 하나를 삭제하거나 다른 곳으로 옮기세요.</translation>
    </message>
    <message>
        <source>Points "%1" and "%2" lie almost on the same place of face "%3", so that the surface is very steep between them: delete one of them, or place one elsewhere.</source>
        <translation>점 "%1"과(와) "%2"이(가) 페이스 "%3"의 거의 같은 위치에 있어 그 사이의 서피스가 매우 가파릅니다. 하나를 삭제하거나 다른 곳으로 옮기세요.</translation>
    </message>
    <message>
        <source>The place of face "%1" nearest to point "%2" is on its boundary, where curves alone decide: the point acts just inside; move it over the face, or change the curve.</source>
        <translation>점 "%2"에 가장 가까운 페이스 "%1"의 위치가 커브만이 모양을 정하는 경계 위에 있습니다. 점은 바로 안쪽에 작용합니다. 점을 페이스 위로 옮기거나 커브를 바꾸세요.</translation>
    </message>
    <message>
        <source>Inner curve "%1" leaves face "%2" at %3 of its length and is left out: split the face along it.</source>
        <translation>내부 커브 "%1"이(가) 길이의 %3 지점에서 페이스 "%2"을(를) 벗어나 제외했습니다. 그 커브를 따라 페이스를 분할하세요.</translation>
    </message>
    <message>
        <source>Inner curve "%1" leaves face "%2" at %3 of its length and is left out: keep it within the face's sides, off them.</source>
        <translation>내부 커브 "%1"이(가) 길이의 %3 지점에서 페이스 "%2"을(를) 벗어나 제외했습니다. 페이스의 변에 닿지 않게 안쪽에 두세요.</translation>
    </message>
    <message>
        <source>Face "%1" keeps only to %2, not to the tolerance of %3: choose a greater one.</source>
        <translation>페이스 "%1"의 오차가 %2(으)로 허용 오차 %3을(를) 지키지 못합니다. 더 큰 값을 선택하세요.</translation>
    </message>
    <message>
        <source>The outlines of the plane face %1 cross each other in the cage: take more segments.</source>
        <translation>평면 페이스 %1의 윤곽선이 케이지에서 서로 교차합니다. 분할 수를 늘리세요.</translation>
    </message>
    <message>
        <source>The outlines of the plane face %1 cross each other: move its strokes apart.</source>
        <translation>평면 페이스 %1의 윤곽선이 서로 교차합니다. 획을 서로 띄우세요.</translation>
    </message>
    <message>
        <source>Face %1 is left out of the attribute network: %2; its curves are there.</source>
        <translation>페이스 %1을(를) 속성 네트워크에서 제외했습니다: %2. 커브는 남아 있습니다.</translation>
    </message>
    <message>
        <source>it has a hole, and faces of networks have none</source>
        <translation>구멍이 있는데 네트워크의 페이스에는 구멍이 있을 수 없습니다</translation>
    </message>
    <message>
        <source>it has %1 sides, and faces of networks have 2 to 12</source>
        <translation>변이 %1개인데 네트워크의 페이스는 변이 2~12개입니다</translation>
    </message>
    <message>
        <source>it lies on both sides of one edge</source>
        <translation>한 에지의 양쪽에 모두 놓여 있습니다</translation>
    </message>
    <message>
        <source>The drawing has fewer than two usable lines along %1: draw at least two construction lines for two of the axes.</source>
        <translation>드로잉에 %1 방향의 쓸 수 있는 선이 두 개보다 적습니다. 두 축에 대해 보조선을 두 개 이상씩 그리세요.</translation>
    </message>
    <message>
        <source>The lines of all three axes are parallel, so there is no perspective to find a camera from: draw lines that converge towards at least one vanishing point.</source>
        <translation>세 축의 선이 모두 평행해 카메라를 찾을 원근이 없습니다. 하나 이상의 소실점으로 모이는 선을 그리세요.</translation>
    </message>
    <message>
        <source>No eye sees the three axes at right angles: the vanishing points form a triangle with an obtuse angle at that of %1; redraw its lines (%2) so that they meet farther away.</source>
        <translation>세 축을 직각으로 보는 시점이 없습니다. 소실점들이 이루는 삼각형에서 %1축 소실점의 각이 둔각입니다. 그 선(%2)이 더 먼 곳에서 만나도록 다시 그리세요.</translation>
    </message>
    <message>
        <source>Stroke %1 doesn't point at the vanishing point of %2 and isn't used for it: check its colour, or draw it again.</source>
        <translation>획 %1이(가) %2축의 소실점을 향하지 않아 사용하지 않습니다. 색을 확인하거나 다시 그리세요.</translation>
    </message>
    <message>
        <source>A drawing with one vanishing point doesn't show how deep things are; a field of view of 50 degrees is assumed: state the field of view, or two known lengths.</source>
        <translation>소실점이 하나인 드로잉에서는 깊이를 알 수 없어 시야각을 50도로 가정합니다. 시야각이나 알려진 길이 두 개를 지정하세요.</translation>
    </message>
    <message>
        <source>Fewer than two usable lines run along %1; its vanishing point follows from the other two: draw two lines along it.</source>
        <translation>%1축 방향의 쓸 수 있는 선이 두 개보다 적어 다른 두 소실점에서 구합니다. 그 방향으로 선을 두 개 그리세요.</translation>
    </message>
    <message>
        <source>The lines along %1 hardly converge, so that the focal length is uncertain by %2 percent: draw more of them, far from each other.</source>
        <translation>%1축 방향의 선이 거의 모이지 않아 초점 거리가 %2퍼센트만큼 불확실합니다. 서로 멀리 떨어진 선을 더 그리세요.</translation>
    </message>
    <message>
        <source>The faces along stroke %1 nearly go on smoothly, but the strokes at its ends don't lie in one plane: turn their ends into a common plane or keep the edge sharp.</source>
        <translation>획 %1 양쪽의 페이스가 거의 매끄럽게 이어지지만 양 끝의 획들이 한 평면에 있지 않습니다. 획의 끝을 한 평면에 맞추거나 에지를 날카롭게 두세요.</translation>
    </message>
    <message>
        <source>The known length of stroke %1 can't be used: give the length, more than 0, of an edge that is tied to the others.</source>
        <translation>획 %1의 알려진 길이를 사용할 수 없습니다. 다른 획과 이어진 에지에 0보다 큰 길이를 지정하세요.</translation>
    </message>
    <message>
        <source>Nothing ties %1 to the rest, so how far away they are is a guess: draw a link stroke between them.</source>
        <translation>%1이(가) 나머지와 이어져 있지 않아 거리를 짐작할 뿐입니다. 그 사이를 잇는 획을 그리세요.</translation>
    </message>
    <message>
        <source>Stroke %1 is drawn as %2 but fits %3: give it that group.</source>
        <translation>획 %1은(는) '%2'(으)로 그려졌지만 '%3'에 더 맞습니다. 그 그룹을 지정하세요.</translation>
    </message>
    <message>
        <source>Stroke %1 is drawn as %2, which contradicts the rest: two corners seem to be drawn at one place there, move them apart.</source>
        <translation>획 %1은(는) '%2'(으)로 그려져 나머지와 모순됩니다. 두 꼭짓점이 한 곳에 그려진 것 같으니 서로 띄우세요.</translation>
    </message>
    <message>
        <source>Stroke %1 is drawn as %2, which contradicts the rest: check its group and its ends.</source>
        <translation>획 %1은(는) '%2'(으)로 그려져 나머지와 모순됩니다. 그룹과 양 끝을 확인하세요.</translation>
    </message>
    <message>
        <source>parallel to %1</source>
        <translation>%1축에 평행</translation>
    </message>
    <message>
        <source>in a plane at right angles to %1</source>
        <translation>%1축에 수직인 평면 안</translation>
    </message>
    <message>
        <source>in a plane with normal %1</source>
        <translation>노멀이 %1축인 평면 안</translation>
    </message>
    <message>
        <source>Draw stroke %1 parallel to %2.</source>
        <translation>획 %1을(를) %2축에 평행하게 그립니다.</translation>
    </message>
    <message>
        <source>Draw stroke %1 in a plane with normal %2.</source>
        <translation>획 %1을(를) 노멀이 %2축인 평면 안에 그립니다.</translation>
    </message>
    <message>
        <source>Ends of %1 would lie behind the eye: check groups and ends.</source>
        <translation>%1의 끝이 시점 뒤에 놓이게 됩니다. 그룹과 양 끝을 확인하세요.</translation>
    </message>
    <message>
        <source>The depth of %1 is uncertain, their plane is seen from its edge: tie their ends by further strokes.</source>
        <translation>%1의 평면이 모서리 방향에서 보여 깊이가 불확실합니다. 획을 더 그려 양 끝을 이으세요.</translation>
    </message>
    <message>
        <source>Stroke %1 crosses the horizon of the plane that its group says, and stays in the picture: check its group.</source>
        <translation>획 %1이(가) 그룹이 나타내는 평면의 지평선을 가로질러 그림 안에만 남습니다. 그룹을 확인하세요.</translation>
    </message>
    <message>
        <source>Stroke %1 has a coordinate that isn't finite or is larger than 1e30, and is left out: draw it again.</source>
        <translation>획 %1의 좌표가 유한하지 않거나 1e30보다 커서 제외했습니다. 다시 그리세요.</translation>
    </message>
    <message>
        <source>Stroke %1 is no longer than a point and is left out: delete it or draw it longer.</source>
        <translation>획 %1이(가) 점만큼 짧아 제외했습니다. 삭제하거나 더 길게 그리세요.</translation>
    </message>
    <message>
        <source>Stroke %1 is left out, since it isn't clear along which axis or in which plane it runs: give it a group.</source>
        <translation>획 %1이(가) 어느 축이나 평면을 따라가는지 분명하지 않아 제외했습니다. 그룹을 지정하세요.</translation>
    </message>
    <message>
        <source>Stroke %1 joins the same vertices along the same line as %2 and is left out: delete one of the two.</source>
        <translation>획 %1이(가) %2과(와) 같은 선을 따라 같은 정점을 이어 제외했습니다. 둘 중 하나를 삭제하세요.</translation>
    </message>
    <message>
        <source>The two ends of %1 are so near to each other that ends around them may be joined to the wrong one: draw larger, or name the ends.</source>
        <translation>%1의 양 끝이 너무 가까워 주변의 끝이 잘못 이어질 수 있습니다. 더 크게 그리거나 끝에 이름을 붙이세요.</translation>
    </message>
    <message>
        <source>Stroke %1 has an end that leads nowhere, so it bounds no face: join it to other strokes.</source>
        <translation>획 %1의 한쪽 끝이 어디에도 이어지지 않아 페이스를 이루지 못합니다. 다른 획에 이으세요.</translation>
    </message>
    <message>
        <source>Stroke %1 is the only connection of two parts, so it bounds no face: draw the other edges between them or remove it.</source>
        <translation>획 %1이(가) 두 부분을 잇는 유일한 획이어서 페이스를 이루지 못합니다. 사이의 다른 에지를 그리거나 이 획을 제거하세요.</translation>
    </message>
    <message>
        <source>The straight strokes %1 bound a face that isn't flat: a stroke is probably missing between them.</source>
        <translation>직선 획 %1이(가) 평평하지 않은 페이스를 둘러쌉니다. 그 사이에 획이 빠진 것 같습니다.</translation>
    </message>
    <message>
        <source>The strokes %1 and %2 meet in a corner of a smooth face from which no third stroke leads on: draw the edge that begins there.</source>
        <translation>획 %1과(와) %2이(가) 스무스 페이스의 꼭짓점에서 만나는데 이어지는 세 번째 획이 없습니다. 그곳에서 시작하는 에지를 그리세요.</translation>
    </message>
    <message>
        <source>The strokes %1 can be given faces in %2 ways that fit about as well: choose the faces there.</source>
        <translation>획 %1에 비슷하게 맞는 페이스 구성이 %2가지 있습니다. 그곳의 페이스를 선택하세요.</translation>
    </message>
    <message>
        <source>No set of faces closes the solid; the strokes %1 lack a face: draw the edges that are missing next to them.</source>
        <translation>솔리드를 닫는 페이스 구성이 없습니다. 획 %1에 페이스가 부족합니다. 그 옆에 빠진 에지를 그리세요.</translation>
    </message>
    <message>
        <source>The search for faces ended at its limit, so a better set may exist: choose some faces by hand or raise the parameter search-limit.</source>
        <translation>페이스 탐색이 한도에서 끝나 더 나은 구성이 있을 수 있습니다. 페이스를 직접 선택하거나 search-limit 매개변수를 늘리세요.</translation>
    </message>
    <message>
        <source>The smooth surface inside the strokes %1 folds over: divide the face by another stroke or make its outline less bent.</source>
        <translation>획 %1 안쪽의 스무스 서피스가 접힙니다. 다른 획으로 페이스를 나누거나 윤곽선을 덜 굽게 그리세요.</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <translation>구멍 %1</translation>
    </message>
    <message>
        <source>Holes %1</source>
        <translation>구멍 %1</translation>
    </message>
    <message>
        <source>1 vertex of a rim lies nearly on another one (within %1 of the diagonal) and counts as the same; it is written as before: weld the source, or keep them apart with --weld 0.</source>
        <translation>구멍 가장자리의 정점 1개가 다른 정점과 거의 겹쳐(대각선의 %1 이내) 같은 것으로 봅니다. 저장은 원래대로 됩니다. 원본의 정점을 병합하거나 '에지 병합 거리'를 0으로 하여 분리하세요.</translation>
    </message>
    <message>
        <source>%1 vertices of rims lie nearly on another one (within %2 of the diagonal) and count as the same; they are written as before: weld the source, or keep them apart with --weld 0.</source>
        <translation>구멍 가장자리의 정점 %1개가 다른 정점과 거의 겹쳐(대각선의 %2 이내) 같은 것으로 봅니다. 저장은 원래대로 됩니다. 원본의 정점을 병합하거나 '에지 병합 거리'를 0으로 하여 분리하세요.</translation>
    </message>
    <message>
        <source>1 face runs against the neighbours: taken the other way round, and written as it was; flip it in the source.</source>
        <translation>페이스 1개의 방향이 이웃과 반대여서 뒤집어 처리했습니다. 저장은 원래대로 됩니다. 원본에서 뒤집으세요.</translation>
    </message>
    <message>
        <source>%1 faces run against the neighbours: taken the other way round, and written as they were; flip them in the source.</source>
        <translation>페이스 %1개의 방향이 이웃과 반대여서 뒤집어 처리했습니다. 저장은 원래대로 됩니다. 원본에서 뒤집으세요.</translation>
    </message>
    <message>
        <source>The orientation is ambiguous: 1 component has only one side; look at what is filled there.</source>
        <translation>방향이 모호합니다. 부분 1개에 면이 하나뿐입니다. 그곳에 메워진 것을 확인하세요.</translation>
    </message>
    <message>
        <source>The orientation is ambiguous: %1 components have only one side; look at what is filled there.</source>
        <translation>방향이 모호합니다. 부분 %1개에 면이 하나뿐입니다. 그곳에 메워진 것을 확인하세요.</translation>
    </message>
    <message>
        <source>1 non-manifold edge has more than two faces and stays as it is: separate the sheets that meet in it.</source>
        <translation>비매니폴드 에지 1개에 페이스가 세 개 이상 붙어 있어 그대로 둡니다. 그곳에서 만나는 면들을 분리하세요.</translation>
    </message>
    <message>
        <source>%1 non-manifold edges have more than two faces and stay as they are: separate the sheets that meet in them.</source>
        <translation>비매니폴드 에지 %1개에 페이스가 세 개 이상 붙어 있어 그대로 둡니다. 그곳에서 만나는 면들을 분리하세요.</translation>
    </message>
    <message>
        <source>1 non-manifold edge has more than two faces and stays as it is; 1 rim ends there and can't be filled: separate the sheets that meet in it.</source>
        <translation>비매니폴드 에지 1개에 페이스가 세 개 이상 붙어 있어 그대로 둡니다. 구멍 가장자리 1개가 그곳에서 끝나 메울 수 없습니다. 그곳에서 만나는 면들을 분리하세요.</translation>
    </message>
    <message>
        <source>1 non-manifold edge has more than two faces and stays as it is; %1 rims end there and can't be filled: separate the sheets that meet in it.</source>
        <translation>비매니폴드 에지 1개에 페이스가 세 개 이상 붙어 있어 그대로 둡니다. 구멍 가장자리 %1개가 그곳에서 끝나 메울 수 없습니다. 그곳에서 만나는 면들을 분리하세요.</translation>
    </message>
    <message>
        <source>%1 non-manifold edges have more than two faces and stay as they are; 1 rim ends there and can't be filled: separate the sheets that meet in them.</source>
        <translation>비매니폴드 에지 %1개에 페이스가 세 개 이상 붙어 있어 그대로 둡니다. 구멍 가장자리 1개가 그곳에서 끝나 메울 수 없습니다. 그곳에서 만나는 면들을 분리하세요.</translation>
    </message>
    <message>
        <source>%1 non-manifold edges have more than two faces and stay as they are; %2 rims end there and can't be filled: separate the sheets that meet in them.</source>
        <translation>비매니폴드 에지 %1개에 페이스가 세 개 이상 붙어 있어 그대로 둡니다. 구멍 가장자리 %2개가 그곳에서 끝나 메울 수 없습니다. 그곳에서 만나는 면들을 분리하세요.</translation>
    </message>
    <message>
        <source>1 hole shares a vertex with another one and was cut apart there: look at what is filled.</source>
        <translation>구멍 1개가 다른 구멍과 정점을 공유해 그곳에서 분리했습니다. 메워진 것을 확인하세요.</translation>
    </message>
    <message>
        <source>%1 holes share a vertex with another one and were cut apart there: look at what is filled.</source>
        <translation>구멍 %1개가 다른 구멍과 정점을 공유해 그곳에서 분리했습니다. 메워진 것을 확인하세요.</translation>
    </message>
    <message>
        <source>1 vertex lies exactly on another one and counts as the same; it is written as it was, so weld the source to get a closed file.</source>
        <translation>정점 1개가 다른 정점과 정확히 겹쳐 같은 것으로 봅니다. 저장은 원래대로 되므로 닫힌 파일이 필요하면 원본의 정점을 병합하세요.</translation>
    </message>
    <message>
        <source>%1 vertices lie exactly on another one and count as the same; they are written as they were, so weld the source to get a closed file.</source>
        <translation>정점 %1개가 다른 정점과 정확히 겹쳐 같은 것으로 봅니다. 저장은 원래대로 되므로 닫힌 파일이 필요하면 원본의 정점을 병합하세요.</translation>
    </message>
    <message>
        <source>1 triangle has next to no area; kept, but not used to continue the surface.</source>
        <translation>삼각형 1개에 면적이 거의 없습니다. 유지하지만 서피스를 잇는 데는 쓰지 않습니다.</translation>
    </message>
    <message>
        <source>%1 triangles have next to no area; kept, but not used to continue the surface.</source>
        <translation>삼각형 %1개에 면적이 거의 없습니다. 유지하지만 서피스를 잇는 데는 쓰지 않습니다.</translation>
    </message>
    <message>
        <source>There is no hole %1: the mesh has %2, numbered from 0; list them first.</source>
        <translation>구멍 %1이(가) 없습니다. 메쉬의 구멍은 %2개이며 번호는 0부터입니다. 먼저 목록을 확인하세요.</translation>
    </message>
    <message>
        <source>not chosen</source>
        <translation>선택되지 않음</translation>
    </message>
    <message>
        <source>the border of an open surface</source>
        <translation>열린 서피스의 경계</translation>
    </message>
    <message>
        <source>the largest hole</source>
        <translation>가장 큰 구멍</translation>
    </message>
    <message>
        <source>wider than the limit</source>
        <translation>제한보다 넓음</translation>
    </message>
    <message>
        <source>asked to stay open</source>
        <translation>열린 채로 두도록 지정됨</translation>
    </message>
    <message>
        <source>The mesh has no faces, so it has no holes to fill: give a mesh with faces.</source>
        <translation>메쉬에 페이스가 없어 메울 구멍도 없습니다. 페이스가 있는 메쉬를 사용하세요.</translation>
    </message>
    <message>
        <source>The mesh has no area: all its faces lie on points or lines; check the scale of its export.</source>
        <translation>메쉬에 면적이 없습니다. 모든 페이스가 점이나 선 위에 있습니다. 내보낼 때의 크기를 확인하세요.</translation>
    </message>
    <message>
        <source>The mesh has more triangles than can be numbered: split it.</source>
        <translation>메쉬의 삼각형이 번호를 매길 수 있는 수보다 많습니다. 나누세요.</translation>
    </message>
    <message>
        <source>1 rim looks like the border of an open surface and stayed open: choose all holes, or this one by its number, to close it too.</source>
        <translation>구멍 가장자리 1개가 열린 서피스의 경계로 보여 열어 두었습니다. 함께 메우려면 모든 구멍이나 그 번호를 선택하세요.</translation>
    </message>
    <message>
        <source>%1 rims look like the border of an open surface and stayed open: choose all holes, or these by their numbers, to close them too.</source>
        <translation>구멍 가장자리 %1개가 열린 서피스의 경계로 보여 열어 두었습니다. 함께 메우려면 모든 구멍이나 그 번호를 선택하세요.</translation>
    </message>
    <message>
        <source>%1 was closed past 1 triangle that hangs there by a corner and stays as it was: delete it in the source.</source>
        <translation>%1을(를) 꼭짓점으로만 매달린 삼각형 1개를 피해 메웠습니다. 그 삼각형은 그대로 있으니 원본에서 삭제하세요.</translation>
    </message>
    <message>
        <source>%1 was closed past %2 triangles that hang there by a corner and stay as they were: delete them in the source.</source>
        <translation>%1을(를) 꼭짓점으로만 매달린 삼각형 %2개를 피해 메웠습니다. 그 삼각형들은 그대로 있으니 원본에서 삭제하세요.</translation>
    </message>
    <message>
        <source>%1 were closed past %2 triangles that hang there by a corner and stay as they were: delete them in the source.</source>
        <translation>%1을(를) 꼭짓점으로만 매달린 삼각형 %2개를 피해 메웠습니다. 그 삼각형들은 그대로 있으니 원본에서 삭제하세요.</translation>
    </message>
    <message>
        <source>%1 stays open, since no patch would be sound (%2): look at the surface around, or trim the rim.</source>
        <translation>%1을(를) 메울 올바른 패치가 없어 열린 채로 둡니다(%2). 주변 서피스를 확인하거나 가장자리를 다듬으세요.</translation>
    </message>
    <message>
        <source>%1 stay open, since no patch would be sound (%2): look at the surface around, or trim the rim.</source>
        <translation>%1을(를) 메울 올바른 패치가 없어 열린 채로 둡니다(%2). 주변 서피스를 확인하거나 가장자리를 다듬으세요.</translation>
    </message>
    <message>
        <source>%1 was filled smooth instead (%2): look at the shape.</source>
        <translation>%1을(를) 대신 스무스 방식으로 메웠습니다(%2). 모양을 확인하세요.</translation>
    </message>
    <message>
        <source>%1 were filled smooth instead (%2): look at the shape.</source>
        <translation>%1을(를) 대신 스무스 방식으로 메웠습니다(%2). 모양을 확인하세요.</translation>
    </message>
    <message>
        <source>%1 was filled bridged instead (%2): look at the shape.</source>
        <translation>%1을(를) 대신 브리지 방식으로 메웠습니다(%2). 모양을 확인하세요.</translation>
    </message>
    <message>
        <source>%1 were filled bridged instead (%2): look at the shape.</source>
        <translation>%1을(를) 대신 브리지 방식으로 메웠습니다(%2). 모양을 확인하세요.</translation>
    </message>
    <message>
        <source>%1 was filled flat instead (%2): look at the shape.</source>
        <translation>%1을(를) 대신 평평하게 메웠습니다(%2). 모양을 확인하세요.</translation>
    </message>
    <message>
        <source>%1 were filled flat instead (%2): look at the shape.</source>
        <translation>%1을(를) 대신 평평하게 메웠습니다(%2). 모양을 확인하세요.</translation>
    </message>
    <message>
        <source>%1 was filled by rbf instead (%2): look at the shape.</source>
        <translation>%1을(를) 대신 rbf 방식으로 메웠습니다(%2). 모양을 확인하세요.</translation>
    </message>
    <message>
        <source>%1 were filled by rbf instead (%2): look at the shape.</source>
        <translation>%1을(를) 대신 rbf 방식으로 메웠습니다(%2). 모양을 확인하세요.</translation>
    </message>
    <message>
        <source>bridged</source>
        <translation>브리지</translation>
    </message>
    <message>
        <source>by rbf</source>
        <translation>rbf 방식</translation>
    </message>
    <message>
        <source>%1 was filled far from what the surface around them shows: look at the shape, or choose flat patches.</source>
        <translation>%1이(가) 주변 서피스에서 예상되는 모양과 멀게 메워졌습니다. 모양을 확인하거나 평평한 패치를 선택하세요.</translation>
    </message>
    <message>
        <source>%1 were filled far from what the surface around them shows: look at the shape, or choose flat patches.</source>
        <translation>%1이(가) 주변 서피스에서 예상되는 모양과 멀게 메워졌습니다. 모양을 확인하거나 평평한 패치를 선택하세요.</translation>
    </message>
    <message>
        <source>%1 was filled by flat patches, which do not continue the surface around them: look at the shape, or leave them open.</source>
        <translation>%1을(를) 주변 서피스와 이어지지 않는 평평한 패치로 메웠습니다. 모양을 확인하거나 열린 채로 두세요.</translation>
    </message>
    <message>
        <source>%1 were filled by flat patches, which do not continue the surface around them: look at the shape, or leave them open.</source>
        <translation>%1을(를) 주변 서피스와 이어지지 않는 평평한 패치로 메웠습니다. 모양을 확인하거나 열린 채로 두세요.</translation>
    </message>
    <message>
        <source>%1 was filled with a fold of more than 120 degrees at the rim: look at the rim, or trim it.</source>
        <translation>%1이(가) 가장자리에서 120도 넘게 접힌 채 메워졌습니다. 가장자리를 확인하거나 다듬으세요.</translation>
    </message>
    <message>
        <source>%1 were filled with a fold of more than 120 degrees at the rim: look at the rim, or trim it.</source>
        <translation>%1이(가) 가장자리에서 120도 넘게 접힌 채 메워졌습니다. 가장자리를 확인하거나 다듬으세요.</translation>
    </message>
    <message>
        <source>%1 was filled beyond the box of the scan, which grows along %2 from %3 to %4: look at the shape, or choose flat patches.</source>
        <translation>%1을(를) 메운 패치가 스캔의 경계 상자를 벗어나 %2축 길이가 %3에서 %4(으)로 늘어납니다. 모양을 확인하거나 평평한 패치를 선택하세요.</translation>
    </message>
    <message>
        <source>%1 were filled beyond the box of the scan, which grows along %2 from %3 to %4: look at the shape, or choose flat patches.</source>
        <translation>%1을(를) 메운 패치가 스캔의 경계 상자를 벗어나 %2축 길이가 %3에서 %4(으)로 늘어납니다. 모양을 확인하거나 평평한 패치를 선택하세요.</translation>
    </message>
    <message>
        <source>Filling the holes of these %1 faces would take about %2 MiB, more than the limit of %3 MiB: raise the limit, or fill the parts of the model one by one.</source>
        <translation>페이스 %1개의 구멍을 메우는 데 약 %2 MiB가 필요해 제한 %3 MiB를 넘습니다. 제한을 늘리거나 모델의 부분을 하나씩 메우세요.</translation>
    </message>
    <message>
        <source>its rim goes through the surface</source>
        <translation>가장자리가 서피스를 뚫고 지나갑니다</translation>
    </message>
    <message>
        <source>the surface around it goes on to hole %1</source>
        <translation>주변 서피스가 구멍 %1(으)로 이어집니다</translation>
    </message>
    <message>
        <source>no patch was found</source>
        <translation>패치를 찾지 못했습니다</translation>
    </message>
    <message>
        <source>the patch would lead far away from its hole</source>
        <translation>패치가 구멍에서 멀리 벗어나게 됩니다</translation>
    </message>
    <message>
        <source>Trimming the rims would leave no face of the mesh: remove fewer rings.</source>
        <translation>가장자리를 다듬으면 메쉬에 페이스가 남지 않습니다. 더 적은 링을 제거하세요.</translation>
    </message>
    <message>
        <source>an edge of the patch has more than two faces</source>
        <translation>패치의 한 에지에 페이스가 세 개 이상 붙어 있습니다</translation>
    </message>
    <message>
        <source>faces of the patch disagree in direction</source>
        <translation>패치의 페이스 방향이 서로 맞지 않습니다</translation>
    </message>
    <message>
        <source>the patch's border isn't the rim</source>
        <translation>패치의 경계가 구멍 가장자리와 다릅니다</translation>
    </message>
    <message>
        <source>a triangle of the patch has no area</source>
        <translation>패치의 삼각형 하나에 면적이 없습니다</translation>
    </message>
    <message>
        <source>parts of the patch touch in a vertex</source>
        <translation>패치의 부분들이 한 정점에서 닿습니다</translation>
    </message>
    <message>
        <source>the patch isn't one simple piece</source>
        <translation>패치가 단순한 한 조각이 아닙니다</translation>
    </message>
    <message>
        <source>the patch cuts through the surface or itself</source>
        <translation>패치가 서피스나 자기 자신을 뚫고 지나갑니다</translation>
    </message>
    <message>
        <source>the patch cuts through another one</source>
        <translation>패치가 다른 패치를 뚫고 지나갑니다</translation>
    </message>
    <message>
        <source>an edge of the patch joins vertices that another patch joins already</source>
        <translation>패치의 한 에지가 다른 패치가 이미 이은 정점들을 잇습니다</translation>
    </message>
    <message>
        <source>the patch is empty</source>
        <translation>패치가 비어 있습니다</translation>
    </message>
    <message>
        <source>a coordinate isn't finite</source>
        <translation>좌표 하나가 유한하지 않습니다</translation>
    </message>
    <message>
        <source>an edge of the patch joins vertices that are joined already</source>
        <translation>패치의 한 에지가 이미 이어진 정점들을 잇습니다</translation>
    </message>
    <message>
        <source>its piece of the mesh was left out</source>
        <translation>메쉬에서 그 조각이 제외되었습니다</translation>
    </message>
    <message>
        <source>hangs at the rim of a hole by a corner</source>
        <translation>구멍 가장자리에 꼭짓점으로만 매달려 있습니다</translation>
    </message>
    <message>
        <source>1 group of faces stays as it is: one polygon can't have a hole, touch itself or have no rim. Dissolve fewer edges.</source>
        <translation>페이스 묶음 1개는 그대로 둡니다. 폴리곤 하나에 구멍이 있거나, 자기 자신에 닿거나, 둘레가 없을 수 없습니다. 더 적은 에지를 디졸브하세요.</translation>
    </message>
    <message>
        <source>%1 groups of faces stay as they are: one polygon can't have a hole, touch itself or have no rim. Dissolve fewer edges.</source>
        <translation>페이스 묶음 %1개는 그대로 둡니다. 폴리곤 하나에 구멍이 있거나, 자기 자신에 닿거나, 둘레가 없을 수 없습니다. 더 적은 에지를 디졸브하세요.</translation>
    </message>
    <message>
        <source>There is no face to inset: select some</source>
        <translation>인셋할 페이스가 없습니다. 페이스를 선택하세요</translation>
    </message>
    <message>
        <source>Face %1 has no room for an inset of %2: take less than %3</source>
        <translation>페이스 %1에 %2만큼 인셋할 공간이 없습니다. %3보다 작은 값을 사용하세요</translation>
    </message>
    <message>
        <source>There is no face to extrude: select some</source>
        <translation>돌출할 페이스가 없습니다. 페이스를 선택하세요</translation>
    </message>
    <message>
        <source>The mesh has no edge %1: it has %2</source>
        <translation>메쉬에 에지 %1이(가) 없습니다. 에지는 %2개입니다</translation>
    </message>
    <message>
        <source>Edge %1 has no quad face: a loop cut needs one</source>
        <translation>에지 %1에 사각형 페이스가 없습니다. 루프 컷에는 사각형 페이스가 필요합니다</translation>
    </message>
    <message>
        <source>The attribute "%1" has another number of values than the mesh has elements, so the edit left it out.</source>
        <translation>속성 "%1"의 값 개수가 메쉬 요소의 개수와 달라 편집에서 제외했습니다.</translation>
    </message>
    <message>
        <source>The edit removed what they belonged to, so %1 went, too.</source>
        <translation>편집으로 대상이 사라져 %1도 함께 없어졌습니다.</translation>
    </message>
    <message>
        <source>the tags of %1</source>
        <translation>태그(%1)</translation>
    </message>
    <message>
        <source>%1 of the mesh's lines used vertices that are gone, so they went, too.</source>
        <translation>메쉬의 선 %1개가 없어진 정점을 사용해 함께 없어졌습니다.</translation>
    </message>
    <message>
        <source>There is no set "%1"</source>
        <translation>세트 "%1"이(가) 없습니다</translation>
    </message>
    <message>
        <source>A set needs a name</source>
        <translation>세트에는 이름이 필요합니다</translation>
    </message>
    <message>
        <source>There is a set "%1" already: choose another name</source>
        <translation>세트 "%1"이(가) 이미 있습니다. 다른 이름을 선택하세요</translation>
    </message>
    <message>
        <source>A set needs a sharpness above 0</source>
        <translation>세트의 날카로움은 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>A set needs at least one edge or vertex: select some</source>
        <translation>세트에는 에지나 정점이 하나 이상 필요합니다. 선택하세요</translation>
    </message>
    <message>
        <source>A set can't be merged with itself: choose two sets</source>
        <translation>세트를 자기 자신과 병합할 수 없습니다. 세트 두 개를 선택하세요</translation>
    </message>
    <message>
        <source>1 part</source>
        <translation>부분 1개</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>부분 %1개</translation>
    </message>
    <message>
        <source>1 part with 1 handle</source>
        <translation>부분 1개(핸들 1개)</translation>
    </message>
    <message>
        <source>1 part with %1 handles</source>
        <translation>부분 1개(핸들 %1개)</translation>
    </message>
    <message>
        <source>%1 parts with 1 handle</source>
        <translation>부분 %1개(핸들 1개)</translation>
    </message>
    <message>
        <source>%1 parts with %2 handles</source>
        <translation>부분 %1개(핸들 %2개)</translation>
    </message>
    <message>
        <source>Piece %1 of the model came out as %2 instead of %3: choose cells of %4 mean edges, or fill holes by patches.</source>
        <translation>모델의 조각 %1이(가) %3이(가) 아니라 %2(으)로 만들어졌습니다. 셀을 평균 에지의 %4배로 하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>Piece %1 of the model came out as %2 instead of %3, with smaller cells too: fill holes by patches, which keep the surface.</source>
        <translation>모델의 조각 %1이(가) 더 작은 셀로도 %3이(가) 아니라 %2(으)로 만들어졌습니다. 서피스를 유지하는 패치로 구멍을 메우세요.</translation>
    </message>
    <message>
        <source>Piece %1 of the model came out as %2 instead of %3, and %4 lost their surface: choose cells of %5 mean edges, or fill holes by patches.</source>
        <translation>모델의 조각 %1이(가) %3이(가) 아니라 %2(으)로 만들어졌고 %4의 서피스가 사라졌습니다. 셀을 평균 에지의 %5배로 하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>Piece %1 of the model came out as %2 instead of %3, and %4 lost their surface, with smaller cells too: fill holes by patches, which keep the surface.</source>
        <translation>모델의 조각 %1이(가) 더 작은 셀로도 %3이(가) 아니라 %2(으)로 만들어졌고 %4의 서피스가 사라졌습니다. 서피스를 유지하는 패치로 구멍을 메우세요.</translation>
    </message>
    <message>
        <source>Piece %1 of the model has lost its surface at %2: choose cells of %3 mean edges, or fill holes by patches.</source>
        <translation>모델의 조각 %1이(가) %2에서 서피스를 잃었습니다. 셀을 평균 에지의 %3배로 하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>Piece %1 of the model has lost its surface at %2, with smaller cells too: fill holes by patches, which keep the surface.</source>
        <translation>모델의 조각 %1이(가) 더 작은 셀로도 %2에서 서피스를 잃었습니다. 서피스를 유지하는 패치로 구멍을 메우세요.</translation>
    </message>
    <message>
        <source>Piece %1 of the model %2: choose smaller cells, or fill holes by patches, which keep the surface.</source>
        <translation>모델의 조각 %1: %2. 더 작은 셀을 선택하거나 서피스를 유지하는 패치로 구멍을 메우세요.</translation>
    </message>
    <message>
        <source>with those that it was made one solid with %1</source>
        <translation>하나의 솔리드로 합친 조각들과 함께 %1</translation>
    </message>
    <message>
        <source>ends %1 short of the scan's box</source>
        <translation>스캔의 경계 상자보다 %1만큼 모자랍니다</translation>
    </message>
    <message>
        <source>leads %1 out of the scan's box</source>
        <translation>스캔의 경계 상자를 %1만큼 벗어납니다</translation>
    </message>
    <message>
        <source>encloses %1 instead of %2</source>
        <translation>부피가 %2이(가) 아니라 %1입니다</translation>
    </message>
    <message>
        <source>came out as %1 where the scan's own sheets make %2</source>
        <translation>스캔의 면은 %2인데 %1(으)로 만들어졌습니다</translation>
    </message>
    <message>
        <source>Piece %1 of the model has %2 farther than half a cell off the scan, where its surface can't be brought nearer without cutting through itself: choose smaller cells, or fill holes by patches.</source>
        <translation>모델의 조각 %1에서 %2이(가) 스캔에서 셀 절반보다 멀리 있습니다. 자기 자신을 뚫지 않고는 더 가까이 옮길 수 없습니다. 더 작은 셀을 선택하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>Piece %1 of the model was left out: its new surface crosses that of piece %2, and no solid stands for both; take them apart, or fill holes by patches, which keep all pieces.</source>
        <translation>모델의 조각 %1을(를) 제외했습니다. 새 서피스가 조각 %2의 서피스와 교차해 둘을 함께 나타내는 솔리드가 없습니다. 서로 떼어 놓거나 모든 조각을 유지하는 패치로 구멍을 메우세요.</translation>
    </message>
    <message>
        <source>Piece %1 of the model was left out: its new surface would lack %2 % of the scan's; choose smaller cells, or fill holes by patches, which keep the surface.</source>
        <translation>모델의 조각 %1을(를) 제외했습니다. 새 서피스에 스캔의 %2 %가 빠지게 됩니다. 더 작은 셀을 선택하거나 서피스를 유지하는 패치로 구멍을 메우세요.</translation>
    </message>
    <message>
        <source>1 more piece was left out for such reasons: choose smaller cells, or fill holes by patches.</source>
        <translation>조각 1개를 같은 이유로 더 제외했습니다. 더 작은 셀을 선택하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>%1 more pieces were left out for such reasons: choose smaller cells, or fill holes by patches.</source>
        <translation>조각 %1개를 같은 이유로 더 제외했습니다. 더 작은 셀을 선택하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>1 more piece has lost detail: choose smaller cells, or fill holes by patches.</source>
        <translation>조각 1개가 디테일을 더 잃었습니다. 더 작은 셀을 선택하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>%1 more pieces have lost detail: choose smaller cells, or fill holes by patches.</source>
        <translation>조각 %1개가 디테일을 더 잃었습니다. 더 작은 셀을 선택하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>1 more piece has other boxes or volumes than the scan's: choose smaller cells, or fill holes by patches.</source>
        <translation>조각 1개의 경계 상자나 부피도 스캔과 다릅니다. 더 작은 셀을 선택하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>%1 more pieces have other boxes or volumes than the scan's: choose smaller cells, or fill holes by patches.</source>
        <translation>조각 %1개의 경계 상자나 부피도 스캔과 다릅니다. 더 작은 셀을 선택하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>1 more piece has vertices farther than half a cell off the scan: choose smaller cells, or fill holes by patches.</source>
        <translation>조각 1개에도 스캔에서 셀 절반보다 멀리 있는 정점이 있습니다. 더 작은 셀을 선택하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>%1 more pieces have vertices farther than half a cell off the scan: choose smaller cells, or fill holes by patches.</source>
        <translation>조각 %1개에도 스캔에서 셀 절반보다 멀리 있는 정점이 있습니다. 더 작은 셀을 선택하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>%1 % of the surface is farther than a twentieth of the model's diagonal from the scan: look at the shape there, or leave those holes open.</source>
        <translation>서피스의 %1 %가 스캔에서 모델 대각선의 20분의 1보다 멀리 있습니다. 그곳의 모양을 확인하거나 그 구멍들을 열린 채로 두세요.</translation>
    </message>
    <message>
        <source>%1 % of the surface is farther than a twentieth of the model's diagonal from the scan, in hole %2: look at the shape there, or leave those holes open.</source>
        <translation>서피스의 %1 %가 스캔에서 모델 대각선의 20분의 1보다 멀리 있습니다(구멍 %2). 그곳의 모양을 확인하거나 그 구멍을 열린 채로 두세요.</translation>
    </message>
    <message>
        <source>%1 % of the surface is farther than a twentieth of the model's diagonal from the scan, in holes %2: look at the shape there, or leave those holes open.</source>
        <translation>서피스의 %1 %가 스캔에서 모델 대각선의 20분의 1보다 멀리 있습니다(구멍 %2). 그곳의 모양을 확인하거나 그 구멍들을 열린 채로 두세요.</translation>
    </message>
    <message>
        <source>Cells are %1 times as large as usual, since the scan's triangles are of many sizes: choose smaller cells to keep the finest detail.</source>
        <translation>스캔의 삼각형 크기가 제각각이어서 셀이 보통의 %1배입니다. 가장 작은 디테일을 유지하려면 더 작은 셀을 선택하세요.</translation>
    </message>
    <message>
        <source>The result has %1 times the faces of the scan, of thin parts or large triangles: choose larger cells, or fill holes by patches.</source>
        <translation>얇은 부분이나 큰 삼각형 때문에 결과의 페이스가 스캔의 %1배입니다. 더 큰 셀을 선택하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>1 piece of the model faces the other way than those that they lie upon and were turned over: turn them in the scan if they are sides of a thin wall.</source>
        <translation>모델의 조각 1개가 겹쳐 있는 조각과 반대 방향이어서 뒤집었습니다. 얇은 벽의 면이라면 스캔에서 뒤집으세요.</translation>
    </message>
    <message>
        <source>%1 pieces of the model face the other way than those that they lie upon and were turned over: turn them in the scan if they are sides of a thin wall.</source>
        <translation>모델의 조각 %1개가 겹쳐 있는 조각과 반대 방향이어서 뒤집었습니다. 얇은 벽의 면이라면 스캔에서 뒤집으세요.</translation>
    </message>
    <message>
        <source>%1 pieces of the model go on in one another like views of one thing and were made one surface: align them better if it is rough.</source>
        <translation>모델의 조각 %1개가 한 물체를 여러 번 스캔한 것처럼 이어져 하나의 서피스로 만들었습니다. 표면이 거칠면 정렬을 개선하세요.</translation>
    </message>
    <message>
        <source>%1 pieces of the model cross or nearly touch each other and were made into one solid: take them apart before if they should stay pieces.</source>
        <translation>모델의 조각 %1개가 교차하거나 거의 닿아 하나의 솔리드로 만들었습니다. 따로 두려면 미리 떼어 놓으세요.</translation>
    </message>
    <message>
        <source>1 pair of faces intersects: look at the patches there, or choose smaller cells.</source>
        <translation>페이스 1쌍이 교차합니다. 그곳의 패치를 확인하거나 더 작은 셀을 선택하세요.</translation>
    </message>
    <message>
        <source>%1 pairs of faces intersect: look at the patches there, or choose smaller cells.</source>
        <translation>페이스 %1쌍이 교차합니다. 그곳의 패치를 확인하거나 더 작은 셀을 선택하세요.</translation>
    </message>
    <message>
        <source>1 pair of faces intersects, %1 of them of different pieces of the model, which cross or nearly touch: take them apart, or choose smaller cells.</source>
        <translation>페이스 1쌍이 교차하며 그중 %1쌍은 교차하거나 거의 닿은 서로 다른 조각의 것입니다. 떼어 놓거나 더 작은 셀을 선택하세요.</translation>
    </message>
    <message>
        <source>%1 pairs of faces intersect, %2 of them of different pieces of the model, which cross or nearly touch: take them apart, or choose smaller cells.</source>
        <translation>페이스 %1쌍이 교차하며 그중 %2쌍은 교차하거나 거의 닿은 서로 다른 조각의 것입니다. 떼어 놓거나 더 작은 셀을 선택하세요.</translation>
    </message>
    <message>
        <source>1 small piece was left out, as asked for: lower the least size to keep them.</source>
        <translation>지정한 대로 작은 조각 1개를 제외했습니다. 유지하려면 최소 크기를 낮추세요.</translation>
    </message>
    <message>
        <source>%1 small pieces were left out, as asked for: lower the least size to keep them.</source>
        <translation>지정한 대로 작은 조각 %1개를 제외했습니다. 유지하려면 최소 크기를 낮추세요.</translation>
    </message>
    <message>
        <source>1 piece has no surface that cubes of this size could find: choose smaller cells.</source>
        <translation>조각 1개에서는 이 크기의 셀로 서피스를 찾지 못했습니다. 더 작은 셀을 선택하세요.</translation>
    </message>
    <message>
        <source>%1 pieces have no surface that cubes of this size could find: choose smaller cells.</source>
        <translation>조각 %1개에서는 이 크기의 셀로 서피스를 찾지 못했습니다. 더 작은 셀을 선택하세요.</translation>
    </message>
    <message>
        <source>1 opening is left where none was: choose smaller cells, or fill holes by patches.</source>
        <translation>없던 구멍 1개가 생겨 남아 있습니다. 더 작은 셀을 선택하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>%1 openings are left where none was: choose smaller cells, or fill holes by patches.</source>
        <translation>없던 구멍 %1개가 생겨 남아 있습니다. 더 작은 셀을 선택하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>Nothing of the model could be remeshed: fill its holes by patches, which keep the surface.</source>
        <translation>모델을 전혀 리메쉬하지 못했습니다. 서피스를 유지하는 패치로 구멍을 메우세요.</translation>
    </message>
    <message>
        <source>neither the field nor a patch closes it</source>
        <translation>필드로도 패치로도 닫히지 않습니다</translation>
    </message>
    <message>
        <source>the border of the joined views</source>
        <translation>합친 스캔의 경계</translation>
    </message>
    <message>
        <source>the new surface left an opening there</source>
        <translation>새 서피스의 그곳이 열려 있습니다</translation>
    </message>
    <message>
        <source>the new surface leads far from the scan there</source>
        <translation>새 서피스가 그곳에서 스캔과 멀리 떨어집니다</translation>
    </message>
    <message>
        <source>Remeshing this model needs about %1, and %2 are allowed: choose cells of %3 times the mean edge, or fill its holes by patches.</source>
        <translation>이 모델을 리메쉬하려면 %1 정도가 필요한데 허용된 메모리는 %2입니다. 셀을 평균 에지의 %3배로 하거나 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>Remeshing this model needs about %1, and %2 are allowed: fill its holes by patches.</source>
        <translation>이 모델을 리메쉬하려면 %1 정도가 필요한데 허용된 메모리는 %2입니다. 구멍을 패치로 메우세요.</translation>
    </message>
    <message>
        <source>The option %1 is out of range: choose %2.</source>
        <translation>옵션 %1이(가) 범위를 벗어났습니다. 가능한 값: %2.</translation>
    </message>
    <message>
        <source>edge (%1,%2)</source>
        <translation>에지 (%1,%2)</translation>
    </message>
    <message>
        <source>There is no vertex %1 to pin in a mesh of %2 vertices.</source>
        <translation>정점이 %2개인 메쉬에 고정할 정점 %1이(가) 없습니다.</translation>
    </message>
    <message>
        <source>edge (%1,%2) is shared by faces %3: split it, so that at most two meet there.</source>
        <translation>에지 (%1,%2)을(를) 페이스 %3이(가) 공유합니다. 두 개까지만 만나도록 분리하세요.</translation>
    </message>
    <message>
        <source>The surface has one side only: at edge (%1,%2) its faces can't agree which way to turn; cut it open there.</source>
        <translation>서피스의 면이 하나뿐입니다. 에지 (%1,%2)에서 페이스의 방향을 맞출 수 없습니다. 그곳을 잘라 여세요.</translation>
    </message>
    <message>
        <source>1 face was turned over to agree with the neighbours: %1.</source>
        <translation>이웃에 맞추어 페이스 1개를 뒤집었습니다: %1.</translation>
    </message>
    <message>
        <source>%1 faces were turned over to agree with the neighbours: %2.</source>
        <translation>이웃에 맞추어 페이스 %1개를 뒤집었습니다: %2.</translation>
    </message>
    <message>
        <source>Surfaces touch in vertex %1 alone: each is refined on its own.</source>
        <translation>서피스들이 정점 %1에서만 닿습니다. 각각 따로 세분화합니다.</translation>
    </message>
    <message>
        <source>Vertex %1 belongs to no face: it stays in the cage and isn't refined.</source>
        <translation>정점 %1이(가) 페이스에 속하지 않습니다. 케이지에 남지만 세분화하지 않습니다.</translation>
    </message>
    <message>
        <source>Face %1 is far from convex, so the surface may fold there: split it.</source>
        <translation>페이스 %1이(가) 심하게 오목해 서피스가 그곳에서 접힐 수 있습니다. 분할하세요.</translation>
    </message>
    <message>
        <source>A tag names edge (%1,%2), but no edge joins these vertices: it is left out.</source>
        <translation>태그가 에지 (%1,%2)을(를) 가리키지만 이 정점들을 잇는 에지가 없어 제외했습니다.</translation>
    </message>
    <message>
        <source>The tag of edge (%1,%2) is left out: its sharpness is negative or no number, where 0 to 10 or infinite is meant.</source>
        <translation>에지 (%1,%2)의 태그를 제외했습니다. 날카로움이 음수이거나 숫자가 아닙니다. 0에서 10 또는 무한이어야 합니다.</translation>
    </message>
    <message>
        <source>Vertex %1 is pinned, but no sharp edge ends there: the pin changes nothing.</source>
        <translation>정점 %1이(가) 고정되어 있지만 그곳에서 끝나는 날카로운 에지가 없어 아무 영향이 없습니다.</translation>
    </message>
    <message>
        <source>The tag of edge (%1,%2) stands alone and shrinks to the middle of its edge: pin its ends, or let chain ends be smooth.</source>
        <translation>에지 (%1,%2)의 태그가 홀로 있어 에지 가운데로 줄어듭니다. 양 끝을 고정하거나 체인의 끝을 매끄럽게 하세요.</translation>
    </message>
    <message>
        <source>The fairing equations can't be solved with this weight; take a greater one.</source>
        <translation>이 가중치로는 고르게 펴기 방정식을 풀 수 없습니다. 더 큰 값을 사용하세요.</translation>
    </message>
    <message>
        <source>The weight of fairing has to be a number above 0.</source>
        <translation>고르게 펴기의 가중치는 0보다 큰 숫자여야 합니다.</translation>
    </message>
    <message>
        <source>The region names face %1 of a mesh with %2 faces; leave it out.</source>
        <translation>영역이 페이스가 %2개인 메쉬의 페이스 %1을(를) 가리킵니다. 빼세요.</translation>
    </message>
    <message>
        <source>1 face of the region isn't planar and was cut into triangles, to be kept exactly.</source>
        <translation>영역의 페이스 1개가 평면이 아니어서 모양을 정확히 유지하도록 삼각형으로 나누었습니다.</translation>
    </message>
    <message>
        <source>%1 faces of the region aren't planar and were cut into triangles, to be kept exactly.</source>
        <translation>영역의 페이스 %1개가 평면이 아니어서 모양을 정확히 유지하도록 삼각형으로 나누었습니다.</translation>
    </message>
    <message>
        <source>OpenSubdiv can't refine this mesh: %1</source>
        <translation>OpenSubdiv가 이 메쉬를 세분화할 수 없습니다: %1</translation>
    </message>
    <message>
        <source>Level %1 would have about %2 faces, %3 edges and %4 vertices, but the limit is %5 faces: take fewer levels, or a higher limit.</source>
        <translation>레벨 %1에서는 페이스가 약 %2개, 에지 %3개, 정점 %4개가 되는데 제한은 페이스 %5개입니다. 레벨을 줄이거나 제한을 늘리세요.</translation>
    </message>
    <message>
        <source>Level %1 would have %2 faces, %3 edges and %4 vertices, but the limit is %5 faces: take fewer levels, or a higher limit.</source>
        <translation>레벨 %1에서는 페이스 %2개, 에지 %3개, 정점 %4개가 되는데 제한은 페이스 %5개입니다. 레벨을 줄이거나 제한을 늘리세요.</translation>
    </message>
    <message>
        <source>1 face has more than three corners and was cut into triangles, which Loop's scheme needs.</source>
        <translation>페이스 1개의 꼭짓점이 세 개를 넘어 Loop 방식에 필요한 삼각형으로 나누었습니다.</translation>
    </message>
    <message>
        <source>%1 faces have more than three corners and were cut into triangles, which Loop's scheme needs.</source>
        <translation>페이스 %1개의 꼭짓점이 세 개를 넘어 Loop 방식에 필요한 삼각형으로 나누었습니다.</translation>
    </message>
    <message>
        <source>'%1' is off and has no input to give in place of its result: switch it on, or link one.</source>
        <translation>'%1'이(가) 꺼져 있고 결과 대신 넘겨줄 입력이 없습니다. 켜거나 입력을 연결하세요.</translation>
    </message>
    <message>
        <source>The transform of '%1' flattens space or has a number that isn't finite or is larger than 1e30: give it a scale other than 0 along each axis.</source>
        <translation>'%1'의 변환이 공간을 납작하게 만들거나 유한하지 않은(또는 1e30보다 큰) 숫자가 있습니다. 각 축의 스케일을 0이 아닌 값으로 지정하세요.</translation>
    </message>
    <message>
        <source>'%1' has no value: import it again or remove it.</source>
        <translation>'%1'에 값이 없습니다. 다시 가져오거나 제거하세요.</translation>
    </message>
    <message>
        <source>'%1' has neither a value nor an operation: remove it.</source>
        <translation>'%1'에 값도 작업도 없습니다. 제거하세요.</translation>
    </message>
    <message>
        <source>'%1' uses the operation '%2', which this Croquis doesn't have: open it with a newer one.</source>
        <translation>'%1'이(가) 사용하는 작업 '%2'이(가) 이 버전의 Croquis에 없습니다. 더 새로운 버전으로 여세요.</translation>
    </message>
    <message>
        <source>'%1' was made with version %2 of %3; this Croquis has version %4: open it with a newer one.</source>
        <translation>'%1'은(는) %3 버전 %2(으)로 만들어졌는데 이 Croquis에는 버전 %4이(가) 있습니다. 더 새로운 버전으로 여세요.</translation>
    </message>
    <message>
        <source>The inputs of '%1' lead back to itself: choose another input.</source>
        <translation>'%1'의 입력이 자기 자신으로 되돌아옵니다. 다른 입력을 선택하세요.</translation>
    </message>
    <message>
        <source>The input '%1' of '%2' isn't one that %3 has: choose another one.</source>
        <translation>'%2'의 입력 '%1'이(가) %3에 없습니다. 다른 입력을 선택하세요.</translation>
    </message>
    <message>
        <source>The input '%1' of '%2' comes from node %3, which isn't there: choose another one.</source>
        <translation>'%2'의 입력 '%1'이(가) 존재하지 않는 노드 %3에서 옵니다. 다른 입력을 선택하세요.</translation>
    </message>
    <message>
        <source>The input '%1' of '%2' comes from the output '%3' of '%4', which isn't there: choose another one.</source>
        <translation>'%2'의 입력 '%1'이(가) '%4'의 존재하지 않는 출력 '%3'에서 옵니다. 다른 입력을 선택하세요.</translation>
    </message>
    <message>
        <source>'%1' waits for '%2', which can't be computed: mend that, and this follows.</source>
        <translation>'%1'이(가) 계산할 수 없는 '%2'을(를) 기다립니다. 그것을 고치면 이어서 계산됩니다.</translation>
    </message>
    <message>
        <source>'%1' needs the output '%2' of '%3', which is off: switch it on, or choose another input.</source>
        <translation>'%1'에는 꺼져 있는 '%3'의 출력 '%2'이(가) 필요합니다. 켜거나 다른 입력을 선택하세요.</translation>
    </message>
    <message>
        <source>Made with version %1 of %2, computed with version %3: compare the result.</source>
        <translation>%2 버전 %1(으)로 만들어졌고 버전 %3(으)로 계산했습니다. 결과를 비교하세요.</translation>
    </message>
    <message>
        <source>There is no node %1.</source>
        <translation>노드 %1이(가) 없습니다.</translation>
    </message>
    <message>
        <source>Internal error (%1); please report it with the input.</source>
        <translation>내부 오류입니다(%1). 입력과 함께 알려 주세요.</translation>
    </message>
    <message>
        <source>There is not enough memory for this; make the input smaller or free some memory.</source>
        <translation>메모리가 부족합니다. 입력을 줄이거나 메모리를 확보하세요.</translation>
    </message>
    <message>
        <source>%1 needs a %2 as its input '%3'.</source>
        <translation>%1의 입력 '%3'에는 %2이(가) 필요합니다.</translation>
    </message>
    <message>
        <source>A report is nested deeper than %1 levels, more than a project file can hold; remove that node.</source>
        <translation>보고서가 프로젝트 파일에 담을 수 있는 %1단계보다 깊이 중첩되어 있습니다. 그 노드를 제거하세요.</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>메쉬</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>드로잉</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>이미지</translation>
    </message>
    <message>
        <source>report</source>
        <translation>보고서</translation>
    </message>
    <message>
        <source>curve network</source>
        <translation>커브 네트워크</translation>
    </message>
    <message>
        <source>attribute network</source>
        <translation>속성 네트워크</translation>
    </message>
    <message>
        <source>perspective drawing</source>
        <translation>투시 드로잉</translation>
    </message>
    <message>
        <source>a face's normal is not of length 1</source>
        <translation>페이스의 노멀 길이가 1이 아닙니다</translation>
    </message>
    <message>
        <source>a face's flatness is not a distance</source>
        <translation>페이스의 평평한 정도가 거리가 아닙니다</translation>
    </message>
    <message>
        <source>its focal length is not positive</source>
        <translation>초점 거리가 양수가 아닙니다</translation>
    </message>
    <message>
        <source>its axes are not at right angles</source>
        <translation>축들이 직각이 아닙니다</translation>
    </message>
    <message>
        <source>its picture's size is negative</source>
        <translation>그림의 크기가 음수입니다</translation>
    </message>
    <message>
        <source>a curve's vertex is not there</source>
        <translation>커브의 정점이 없습니다</translation>
    </message>
    <message>
        <source>a curve has no pieces</source>
        <translation>커브에 조각이 없습니다</translation>
    </message>
    <message>
        <source>a curve's piece begins elsewhere</source>
        <translation>커브의 조각이 다른 곳에서 시작합니다</translation>
    </message>
    <message>
        <source>a curve ends elsewhere</source>
        <translation>커브가 다른 곳에서 끝납니다</translation>
    </message>
    <message>
        <source>two curves have one name</source>
        <translation>커브 두 개의 이름이 같습니다</translation>
    </message>
    <message>
        <source>its plane has no right angle</source>
        <translation>평면의 축이 직각이 아닙니다</translation>
    </message>
    <message>
        <source>a channel's type is not known</source>
        <translation>채널의 유형을 알 수 없습니다</translation>
    </message>
    <message>
        <source>a kind of something is not known</source>
        <translation>알 수 없는 종류가 있습니다</translation>
    </message>
    <message>
        <source>a number isn't finite or is larger than 1e30</source>
        <translation>유한하지 않거나 1e30보다 큰 숫자가 있습니다</translation>
    </message>
    <message>
        <source>its faces or lines are not whole</source>
        <translation>페이스나 선이 온전하지 않습니다</translation>
    </message>
    <message>
        <source>a vertex index is out of range</source>
        <translation>정점 인덱스가 범위를 벗어났습니다</translation>
    </message>
    <message>
        <source>a channel has not one value per element</source>
        <translation>채널의 값이 요소마다 하나씩 있지 않습니다</translation>
    </message>
    <message>
        <source>a stroke has no pieces</source>
        <translation>획에 조각이 없습니다</translation>
    </message>
    <message>
        <source>a stroke's piece begins elsewhere</source>
        <translation>획의 조각이 다른 곳에서 시작합니다</translation>
    </message>
    <message>
        <source>a stroke's weight is not positive</source>
        <translation>획의 가중치가 양수가 아닙니다</translation>
    </message>
    <message>
        <source>a stroke's length is not positive</source>
        <translation>획의 길이가 양수가 아닙니다</translation>
    </message>
    <message>
        <source>its sheet's size is negative</source>
        <translation>용지의 크기가 음수입니다</translation>
    </message>
    <message>
        <source>its field of view is not positive</source>
        <translation>시야각이 양수가 아닙니다</translation>
    </message>
    <message>
        <source>its field of view is too wide</source>
        <translation>시야각이 너무 넓습니다</translation>
    </message>
    <message>
        <source>its number of shells is not positive</source>
        <translation>셸의 수가 양수가 아닙니다</translation>
    </message>
    <message>
        <source>two strokes have one name</source>
        <translation>획 두 개의 이름이 같습니다</translation>
    </message>
    <message>
        <source>a picture has no pixels</source>
        <translation>이미지에 픽셀이 없습니다</translation>
    </message>
    <message>
        <source>a picture has no bytes</source>
        <translation>이미지에 데이터가 없습니다</translation>
    </message>
    <message>
        <source>a curve's weight is not positive</source>
        <translation>커브의 가중치가 양수가 아닙니다</translation>
    </message>
    <message>
        <source>it is nested too deeply</source>
        <translation>너무 깊이 중첩되어 있습니다</translation>
    </message>
    <message>
        <source>a report's kind of value is not known</source>
        <translation>보고서 값의 종류를 알 수 없습니다</translation>
    </message>
    <message>
        <source>its layout is not known</source>
        <translation>배치를 알 수 없습니다</translation>
    </message>
    <message>
        <source>auto, or two names as A,B or A,B=0.55, A,B=rest or A,B=apart</source>
        <translation>auto 또는 두 이름: A,B, A,B=0.55, A,B=rest, A,B=apart</translation>
    </message>
    <message>
        <source>No face of the network could be evaluated.</source>
        <translation>네트워크의 페이스를 하나도 계산하지 못했습니다.</translation>
    </message>
    <message>
        <source>These edits were made for a mesh with other faces: apply them to the new mesh by the nearest places, or keep the shape.</source>
        <translation>이 편집은 페이스가 다른 메쉬에서 만들어졌습니다. 가장 가까운 위치를 기준으로 새 메쉬에 적용하거나 모양을 유지하세요.</translation>
    </message>
    <message>
        <source>the least and the most points, 4 to 2000, such as 30:300</source>
        <translation>점의 최소 수와 최대 수(4~2000), 예: 30:300</translation>
    </message>
    <message>
        <source>Not looked at in mode remesh: %1.</source>
        <translation>remesh 모드에서는 다음을 사용하지 않습니다: %1.</translation>
    </message>
    <message>
        <source>Not looked at in mode patch: %1.</source>
        <translation>patch 모드에서는 다음을 사용하지 않습니다: %1.</translation>
    </message>
    <message>
        <source>'%1' is no value for holes: %2</source>
        <translation>'%1'은(는) holes의 값이 될 수 없습니다: %2</translation>
    </message>
    <message>
        <source>requests begin with the numbers of holes, counted from 0, such as '0,3-5: fill'.</source>
        <translation>요청은 0부터 세는 구멍 번호로 시작합니다. 예: '0,3-5: fill'.</translation>
    </message>
    <message>
        <source>a hole can be given fill, leave, bridge, rbf, smooth, flat, kernel NAME, bulge -1..1, trim 0..3 or through X Y Z.</source>
        <translation>구멍에는 fill, leave, bridge, rbf, smooth, flat, kernel NAME, bulge -1..1, trim 0..3, through X Y Z를 지정할 수 있습니다.</translation>
    </message>
    <message>
        <source>it takes holes and what is wanted of them, such as '3: leave; 5-7: flat'.</source>
        <translation>구멍과 처리 방법을 적습니다. 예: '3: leave; 5-7: flat'.</translation>
    </message>
    <message>
        <source>a bridge joins two holes or more, such as '2+9: bridge'.</source>
        <translation>브리지는 구멍 두 개 이상을 잇습니다. 예: '2+9: bridge'.</translation>
    </message>
    <message>
        <source>the numbers of holes, counted from 0, such as 0,3-5</source>
        <translation>0부터 세는 구멍 번호, 예: 0,3-5</translation>
    </message>
    <message>
        <source>pairs of vertices, counted from 0, such as 3-7,7-12</source>
        <translation>0부터 세는 정점의 쌍, 예: 3-7,7-12</translation>
    </message>
    <message>
        <source>'%1' is no value for edges: no edge joins these vertices.</source>
        <translation>'%1'은(는) edges의 값이 될 수 없습니다. 이 정점들을 잇는 에지가 없습니다.</translation>
    </message>
    <message>
        <source>Stroke %1 is left out, as the parameter ignore says.</source>
        <translation>획 %1을(를) ignore 매개변수에 따라 제외했습니다.</translation>
    </message>
    <message>
        <source>a place of the drawing and its coordinates, such as 314,527=0,0,0</source>
        <translation>드로잉의 위치와 그 좌표, 예: 314,527=0,0,0</translation>
    </message>
    <message>
        <source>a stroke and its length, such as e03=4</source>
        <translation>획과 그 길이, 예: e03=4</translation>
    </message>
    <message>
        <source>There is no stroke '%1' in the drawing: %2 takes names of strokes.</source>
        <translation>드로잉에 획 '%1'이(가) 없습니다. %2에는 획의 이름을 지정합니다.</translation>
    </message>
    <message>
        <source>Subdivision carries shape and tags alone; left out: %1.</source>
        <translation>세분화는 모양과 태그만 전달합니다. 제외된 것: %1.</translation>
    </message>
    <message>
        <source>polylines</source>
        <translation>폴리라인</translation>
    </message>
    <message>
        <source>a number from -1 to 2, such as 0.7</source>
        <translation>-1에서 2 사이의 숫자, 예: 0.7</translation>
    </message>
    <message>
        <source>auto or a number from -1 to 2</source>
        <translation>auto 또는 -1에서 2 사이의 숫자</translation>
    </message>
    <message>
        <source>The network has no faces: give it loops of curves.</source>
        <translation>네트워크에 페이스가 없습니다. 커브로 루프를 만드세요.</translation>
    </message>
    <message>
        <source>There is no hole %1: the mesh has %2; see the list of fill.</source>
        <translation>구멍 %1이(가) 없습니다. 메쉬의 구멍은 %2개입니다. 구멍 목록을 확인하세요.</translation>
    </message>
    <message>
        <source>Vertex %1 is in the rim of no hole.</source>
        <translation>정점 %1은(는) 어느 구멍의 가장자리에도 없습니다.</translation>
    </message>
    <message>
        <source>Hole %1 is left open: %2; divide it otherwise (sides, corner), or use fill.</source>
        <translation>구멍 %1을(를) 열린 채로 둡니다: %2. 다르게 나누거나(sides, corner) 구멍 메우기를 사용하세요.</translation>
    </message>
    <message>
        <source>A patch has 3 to 12 sides; 0 takes as many as the rim has corners.</source>
        <translation>패치의 변은 3~12개입니다. 0이면 가장자리의 코너 수만큼 사용합니다.</translation>
    </message>
    <message>
        <source>The axis of the rotation has no length</source>
        <translation>회전축에 길이가 없습니다</translation>
    </message>
    <message>
        <source>Give `by` or `distance`: how far the faces are extruded</source>
        <translation>페이스를 돌출할 거리를 `by`나 `distance`로 지정하세요</translation>
    </message>
    <message>
        <source>A loop is cut from one edge, and %1 are given</source>
        <translation>루프 컷은 에지 하나에서 시작하는데 %1개가 지정되었습니다</translation>
    </message>
    <message>
        <source>'%1': there is no vertex %2, only %3 vertices, counted from 0.</source>
        <translation>'%1': 정점 %2이(가) 없습니다. 정점은 %3개이며 0부터 셉니다.</translation>
    </message>
    <message>
        <source>'%1': there is no edge %2, only %3 edges, counted from 0.</source>
        <translation>'%1': 에지 %2이(가) 없습니다. 에지는 %3개이며 0부터 셉니다.</translation>
    </message>
    <message>
        <source>'%1': there is no face %2, only %3 faces, counted from 0.</source>
        <translation>'%1': 페이스 %2이(가) 없습니다. 페이스는 %3개이며 0부터 셉니다.</translation>
    </message>
    <message>
        <source>There is no edit '%1'.</source>
        <translation>편집 '%1'이(가) 없습니다.</translation>
    </message>
    <message>
        <source>'%1': the mesh has no %2.</source>
        <translation>'%1': 메쉬에 %2이(가) 없습니다.</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>정점</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>에지</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>페이스</translation>
    </message>
    <message>
        <source>it works on %1</source>
        <translation>%1에 적용됩니다</translation>
    </message>
    <message>
        <source>'%1' is no number of an element, counted from 0, such as 0,3-5</source>
        <translation>'%1'은(는) 0부터 세는 요소 번호가 아닙니다. 예: 0,3-5</translation>
    </message>
    <message>
        <source>'%1=' names no element</source>
        <translation>'%1='에 요소가 없습니다</translation>
    </message>
    <message>
        <source>'%1' is not written as name=value</source>
        <translation>'%1'이(가) 이름=값 형식이 아닙니다</translation>
    </message>
    <message>
        <source>its elements are given twice</source>
        <translation>요소가 두 번 지정되었습니다</translation>
    </message>
    <message>
        <source>there is no '%1': it takes %2</source>
        <translation>'%1'이(가) 없습니다. 사용할 수 있는 것: %2</translation>
    </message>
    <message>
        <source>'%1' is given twice</source>
        <translation>'%1'이(가) 두 번 지정되었습니다</translation>
    </message>
    <message>
        <source>there is no edit '%1', but %2</source>
        <translation>편집 '%1'이(가) 없습니다. 있는 것: %2</translation>
    </message>
    <message>
        <source>say with %1 what is to be edited</source>
        <translation>편집할 대상을 %1(으)로 지정하세요</translation>
    </message>
    <message>
        <source>The system gives no thread to compute on (%1); close other programs.</source>
        <translation>시스템에서 계산할 스레드를 얻지 못했습니다(%1). 다른 프로그램을 닫으세요.</translation>
    </message>
    <message>
        <source>There is no such step</source>
        <translation>그런 단계가 없습니다</translation>
    </message>
    <message>
        <source>"%1" isn't a step: it is what its chain begins with</source>
        <translation>"%1"은(는) 단계가 아니라 체인의 시작입니다</translation>
    </message>
    <message>
        <source>There is no operation "%1"</source>
        <translation>작업 "%1"이(가) 없습니다</translation>
    </message>
    <message>
        <source>"%1" works on nothing, so it has no place in a chain</source>
        <translation>"%1"은(는) 입력을 사용하지 않아 체인에 넣을 수 없습니다</translation>
    </message>
    <message>
        <source>"%1" can't be taken away: "%2" needs a %3</source>
        <translation>"%1"을(를) 제거할 수 없습니다. "%2"에 %3이(가) 필요합니다</translation>
    </message>
    <message>
        <source>"%1" works on a %2, and "%3" gives none</source>
        <translation>"%1"에는 %2이(가) 필요한데 "%3"의 결과가 그것이 아닙니다</translation>
    </message>
    <message>
        <source>"%1" can't be taken away alone: nothing is before it</source>
        <translation>"%1"만 제거할 수 없습니다. 앞에 아무것도 없습니다</translation>
    </message>
    <message>
        <source>"%1" can't be switched off: it makes another kind of thing than it is given</source>
        <translation>"%1"은(는) 입력과 종류가 다른 결과를 만들기 때문에 끌 수 없습니다</translation>
    </message>
    <message>
        <source>"%1" can't come before "%2": nothing is before that</source>
        <translation>"%1"을(를) "%2" 앞에 둘 수 없습니다. 그 앞에 아무것도 없습니다</translation>
    </message>
    <message>
        <source>"%1" can't come before "%2": another chain uses that, too</source>
        <translation>"%1"을(를) "%2" 앞에 둘 수 없습니다. 다른 체인에서도 사용합니다</translation>
    </message>
    <message>
        <source>"%1" can't come before "%2": it works on another kind of thing</source>
        <translation>"%1"을(를) "%2" 앞에 둘 수 없습니다. 다른 종류에 적용되는 단계입니다</translation>
    </message>
    <message>
        <source>"%1" is the first step already</source>
        <translation>"%1"은(는) 이미 첫 단계입니다</translation>
    </message>
    <message>
        <source>"%1" is the last step already</source>
        <translation>"%1"은(는) 이미 마지막 단계입니다</translation>
    </message>
    <message>
        <source>"%1" can't be frozen: "%2" goes on from another result of it</source>
        <translation>"%1"을(를) 프리즈할 수 없습니다. "%2"이(가) 다른 결과를 이어서 사용합니다</translation>
    </message>
    <message>
        <source>An object can't stand there: its numbers must be finite, and its size above 0</source>
        <translation>오브젝트를 그곳에 둘 수 없습니다. 숫자는 유한하고 크기는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>"%1" has no edits to apply again</source>
        <translation>"%1"에는 다시 적용할 편집이 없습니다</translation>
    </message>
    <message>
        <source>"%1" can't be applied again before the step before it is computed</source>
        <translation>앞 단계가 계산되기 전에는 "%1"을(를) 다시 적용할 수 없습니다</translation>
    </message>
    <message>
        <source>"%1" can't be frozen before it is computed: wait for it, or mend what it reports</source>
        <translation>계산되기 전에는 "%1"을(를) 프리즈할 수 없습니다. 기다리거나 보고된 문제를 고치세요</translation>
    </message>
    <message>
        <source>The mesh that "%1" was made for isn't kept any more, so the places of its elements aren't known: undo the change before it, apply it by number, or keep the shape</source>
        <translation>"%1"을(를) 만들 때의 메쉬가 더 이상 없어 요소의 위치를 알 수 없습니다. 앞의 변경을 실행 취소하거나, 번호 기준으로 적용하거나, 모양을 유지하세요</translation>
    </message>
    <message>
        <source>The picture needs a finite place, a scale above 0 and an opacity from 0 to 1; type other numbers.</source>
        <translation>이미지에는 유한한 위치, 0보다 큰 스케일, 0에서 1 사이의 불투명도가 필요합니다. 다른 숫자를 입력하세요.</translation>
    </message>
    <message>
        <source>The scan has no hole %1</source>
        <translation>스캔에 구멍 %1이(가) 없습니다</translation>
    </message>
    <message>
        <source>There is no operation that edits computed meshes</source>
        <translation>계산된 메쉬를 편집하는 작업이 없습니다</translation>
    </message>
    <message>
        <source>The mesh can't be edited before it is computed</source>
        <translation>계산되기 전에는 메쉬를 편집할 수 없습니다</translation>
    </message>
    <message>
        <source>"%1" holds no mesh</source>
        <translation>"%1"에 메쉬가 없습니다</translation>
    </message>
    <message>
        <source>The mesh has no vertex %1</source>
        <translation>메쉬에 정점 %1이(가) 없습니다</translation>
    </message>
    <message>
        <source>The mesh has no edge %1</source>
        <translation>메쉬에 에지 %1이(가) 없습니다</translation>
    </message>
    <message>
        <source>The mesh has no face %1</source>
        <translation>메쉬에 페이스 %1이(가) 없습니다</translation>
    </message>
    <message>
        <source>Crease sets belong to meshes that aren't computed: freeze the step first</source>
        <translation>크리스 세트는 계산되지 않은 메쉬에만 있습니다. 먼저 단계를 프리즈하세요</translation>
    </message>
    <message>
        <source>The drawing has no stroke "%1"; choose one of those it has.</source>
        <translation>드로잉에 획 "%1"이(가) 없습니다. 있는 획 중에서 선택하세요.</translation>
    </message>
    <message>
        <source>Stroke "%1" has %2 points and no point %3; choose one of those it has.</source>
        <translation>획 "%1"의 점은 %2개이고 점 %3이(가) 없습니다. 있는 점 중에서 선택하세요.</translation>
    </message>
    <message>
        <source>A stroke's length is a number above 0; type another one.</source>
        <translation>획의 길이는 0보다 큰 숫자입니다. 다른 값을 입력하세요.</translation>
    </message>
    <message>
        <source>Nothing is made of the drawing; add the step that makes a solid of it.</source>
        <translation>드로잉으로 만든 것이 없습니다. 솔리드를 만드는 단계를 추가하세요.</translation>
    </message>
    <message>
        <source>There is no drawing in perspective; begin one first.</source>
        <translation>투시 드로잉이 없습니다. 먼저 시작하세요.</translation>
    </message>
    <message>
        <source>The drawing has no places in space yet; correct its lines first.</source>
        <translation>드로잉의 공간 위치를 아직 알 수 없습니다. 먼저 선을 고치세요.</translation>
    </message>
    <message>
        <source>The known point needs finite coordinates; type other ones.</source>
        <translation>좌표를 아는 점에는 유한한 좌표가 필요합니다. 다른 값을 입력하세요.</translation>
    </message>
    <message>
        <source>The unit "%1" isn't known; choose mm, cm, m or in.</source>
        <translation>단위 "%1"을(를) 알 수 없습니다. mm, cm, m, in 중에서 선택하세요.</translation>
    </message>
    <message>
        <source>The field of view lies between 0 and 180 degrees; type another one.</source>
        <translation>시야각은 0도와 180도 사이입니다. 다른 값을 입력하세요.</translation>
    </message>
    <message>
        <source>The sheet needs a width and a height above 0; type other ones.</source>
        <translation>용지의 너비와 높이는 0보다 커야 합니다. 다른 값을 입력하세요.</translation>
    </message>
    <message>
        <source>The stroke has no samples; draw it again.</source>
        <translation>획에 샘플이 없습니다. 다시 그리세요.</translation>
    </message>
    <message>
        <source>The stroke has a place that is not finite; draw it again.</source>
        <translation>획에 유한하지 않은 위치가 있습니다. 다시 그리세요.</translation>
    </message>
    <message>
        <source>There is no stroke %1 with a point %2; choose one of the drawing.</source>
        <translation>점 %2이(가) 있는 획 %1이(가) 없습니다. 드로잉에 있는 것을 선택하세요.</translation>
    </message>
    <message>
        <source>Stroke %1 has no samples; remove it.</source>
        <translation>획 %1에 샘플이 없습니다. 제거하세요.</translation>
    </message>
    <message>
        <source>Stroke %1 has a place that is not finite; draw it again.</source>
        <translation>획 %1에 유한하지 않은 위치가 있습니다. 다시 그리세요.</translation>
    </message>
    <message>
        <source>No closed loop of 2 to 12 curves goes around this place: close the gaps, or select the curves of the loop.</source>
        <translation>이 위치를 둘러싸는 커브 2~12개의 닫힌 루프가 없습니다. 틈을 닫거나 루프의 커브를 선택하세요.</translation>
    </message>
    <message>
        <source>This program was built without OpenCASCADE, which writes STEP files: install the Debian package libocct-data-exchange-dev (scripts/setup step), then build Croquis again.</source>
        <translation>이 프로그램은 STEP 파일을 쓰는 OpenCASCADE 없이 빌드되었습니다. Debian 패키지 libocct-data-exchange-dev를 설치하고(scripts/setup step) Croquis를 다시 빌드하세요.</translation>
    </message>
    <message>
        <source>OpenCASCADE can't write this solid as STEP: write a mesh.</source>
        <translation>OpenCASCADE가 이 솔리드를 STEP으로 쓸 수 없습니다. 메쉬로 내보내세요.</translation>
    </message>
    <message>
        <source>A solid without faces can't be written as STEP: see the other findings.</source>
        <translation>페이스가 없는 솔리드는 STEP으로 쓸 수 없습니다. 다른 검사 결과를 확인하세요.</translation>
    </message>
    <message>
        <source>OpenCASCADE can't write this solid as STEP (%1): write a mesh.</source>
        <translation>OpenCASCADE가 이 솔리드를 STEP으로 쓸 수 없습니다(%1). 메쉬로 내보내세요.</translation>
    </message>
    <message>
        <source>The picture's width is %1 pixels, but it must be from 1 to %2.</source>
        <translation>이미지의 너비가 %1픽셀인데 1에서 %2 사이여야 합니다.</translation>
    </message>
    <message>
        <source>The picture's height is %1 pixels, but it must be from 1 to %2.</source>
        <translation>이미지의 높이가 %1픽셀인데 1에서 %2 사이여야 합니다.</translation>
    </message>
    <message>
        <source>"%1" can't be written</source>
        <translation>"%1"에 쓸 수 없습니다</translation>
    </message>
    <message>
        <source>There is no shipped sample named "%1"</source>
        <translation>"%1"(이)라는 기본 제공 예제가 없습니다</translation>
    </message>
    <message>
        <source>"%1" is open in another window of Croquis, too: whoever saves last replaces what the other saved, so close one of them or save under another name</source>
        <translation>"%1"이(가) 다른 Croquis 창에도 열려 있습니다. 나중에 저장한 쪽이 다른 쪽을 덮어쓰므로 하나를 닫거나 다른 이름으로 저장하세요</translation>
    </message>
    <message>
        <source>The picture "%1" can't be read: %2; save it again as PNG or JPEG</source>
        <translation>이미지 "%1"을(를) 읽을 수 없습니다: %2. PNG나 JPEG로 다시 저장하세요</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>비어 있습니다</translation>
    </message>
    <message>
        <source>its end is missing</source>
        <translation>끝부분이 없습니다</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>손상되었습니다</translation>
    </message>
    <message>
        <source>"%1" is no project, drawing, mesh or picture: open %2</source>
        <translation>"%1"은(는) 프로젝트, 드로잉, 메쉬, 이미지가 아닙니다. 열 수 있는 형식: %2</translation>
    </message>
    <message>
        <source>The mesh isn't closed: 1 edge is open.</source>
        <translation>메쉬가 닫혀 있지 않습니다. 에지 1개가 열려 있습니다.</translation>
    </message>
    <message>
        <source>The mesh isn't closed: %1 edges are open.</source>
        <translation>메쉬가 닫혀 있지 않습니다. 에지 %1개가 열려 있습니다.</translation>
    </message>
    <message>
        <source>The mesh crosses itself in 1 place.</source>
        <translation>메쉬가 1곳에서 자기 자신과 교차합니다.</translation>
    </message>
    <message>
        <source>The mesh crosses itself in %1 places.</source>
        <translation>메쉬가 %1곳에서 자기 자신과 교차합니다.</translation>
    </message>
    <message>
        <source>The mesh isn't closed: 1 edge is open, and it %1.</source>
        <translation>메쉬가 닫혀 있지 않고 에지 1개가 열려 있습니다. 또한 %1.</translation>
    </message>
    <message>
        <source>The mesh isn't closed: %1 edges are open, and it %2.</source>
        <translation>메쉬가 닫혀 있지 않고 에지 %1개가 열려 있습니다. 또한 %2.</translation>
    </message>
    <message>
        <source>crosses itself in 1 place</source>
        <translation>1곳에서 자기 자신과 교차합니다</translation>
    </message>
    <message>
        <source>crosses itself in %1 places</source>
        <translation>%1곳에서 자기 자신과 교차합니다</translation>
    </message>
    <message>
        <source>There is no mesh to export</source>
        <translation>내보낼 메쉬가 없습니다</translation>
    </message>
    <message>
        <source>There is no finished mesh to export yet: wait until it is computed</source>
        <translation>내보낼 완성된 메쉬가 아직 없습니다. 계산될 때까지 기다리세요</translation>
    </message>
    <message>
        <source>There is no finished mesh to export yet: show it first, so that it is computed</source>
        <translation>내보낼 완성된 메쉬가 아직 없습니다. 계산되도록 먼저 표시하세요</translation>
    </message>
    <message>
        <source>There is no finished mesh of "%1" to export yet: wait until it is computed</source>
        <translation>내보낼 "%1"의 완성된 메쉬가 아직 없습니다. 계산될 때까지 기다리세요</translation>
    </message>
    <message>
        <source>There is no finished mesh of "%1" to export yet: show it first, so that it is computed</source>
        <translation>내보낼 "%1"의 완성된 메쉬가 아직 없습니다. 계산되도록 먼저 표시하세요</translation>
    </message>
    <message>
        <source>"%1" names no mesh format: use %2</source>
        <translation>"%1"은(는) 메쉬 형식이 아닙니다. 사용할 수 있는 형식: %2</translation>
    </message>
    <message>
        <source>There is no finished %1 to export yet</source>
        <translation>내보낼 완성된 %1이(가) 아직 없습니다</translation>
    </message>
    <message>
        <source>There is no finished solid of a drawing in perspective to export yet</source>
        <translation>내보낼 투시 드로잉의 완성된 솔리드가 아직 없습니다</translation>
    </message>
    <message>
        <source>The solid doesn't fit into this machine's memory.</source>
        <translation>솔리드가 이 컴퓨터의 메모리에 들어가지 않습니다.</translation>
    </message>
    <message>
        <source>There is nothing to scale to: select a mesh while another object is visible</source>
        <translation>크기를 맞출 대상이 없습니다. 다른 오브젝트가 보이는 상태에서 메쉬를 선택하세요</translation>
    </message>
    <message>
        <source>There are no faces named "%1" in %2</source>
        <translation>%2에 "%1"(이)라는 페이스가 없습니다</translation>
    </message>
    <message>
        <source>There is no finished mesh to freeze: press 3 or fill holes first</source>
        <translation>프리즈할 완성된 메쉬가 없습니다. 먼저 3을 누르거나 구멍을 메우세요</translation>
    </message>
    <message>
        <source>No faces are selected: pick those to keep first (F11)</source>
        <translation>선택된 페이스가 없습니다. 먼저 유지할 페이스를 선택하세요(F11)</translation>
    </message>
    <message>
        <source>The mesh is computed: freeze its last step first</source>
        <translation>계산된 메쉬입니다. 먼저 마지막 단계를 프리즈하세요</translation>
    </message>
    <message>
        <source>There is no mesh whose holes could be filled: open one first</source>
        <translation>구멍을 메울 메쉬가 없습니다. 먼저 메쉬를 여세요</translation>
    </message>
    <message>
        <source>%1 has no holes: every edge has faces on both sides; to remesh it choose Modify &gt; Add step</source>
        <translation>%1에 구멍이 없습니다. 모든 에지의 양쪽에 페이스가 있습니다. 리메쉬하려면 수정 &gt; 단계 추가를 선택하세요</translation>
    </message>
    <message>
        <source>There is no hole %1</source>
        <translation>구멍 %1이(가) 없습니다</translation>
    </message>
    <message>
        <source>join faces</source>
        <translation>페이스 연결</translation>
    </message>
    <message>
        <source>look for cuts</source>
        <translation>교차 검사</translation>
    </message>
    <message>
        <source>compare with the scan</source>
        <translation>스캔과 비교</translation>
    </message>
    <message>
        <source>read</source>
        <translation>읽는 중</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>깊이 계산</translation>
    </message>
    <message>
        <source>search</source>
        <translation>탐색</translation>
    </message>
    <message>
        <source>polygonize</source>
        <translation>폴리곤화</translation>
    </message>
    <message>
        <source>look for lost detail</source>
        <translation>손실된 디테일 검사</translation>
    </message>
    <message>
        <source>write</source>
        <translation>쓰는 중</translation>
    </message>
    <message>
        <source>unite pieces that cross</source>
        <translation>교차하는 조각 합치기</translation>
    </message>
    <message>
        <source>refine</source>
        <translation>세분화</translation>
    </message>
    <message>
        <source>merge flat faces</source>
        <translation>평평한 페이스 병합</translation>
    </message>
    <message>
        <source>look for openings</source>
        <translation>열린 곳 검사</translation>
    </message>
    <message>
        <source>inflate</source>
        <translation>부풀리기</translation>
    </message>
    <message>
        <source>check</source>
        <translation>검사</translation>
    </message>
    <message>
        <source>verify patches</source>
        <translation>패치 확인</translation>
    </message>
    <message>
        <source>verify</source>
        <translation>확인</translation>
    </message>
    <message>
        <source>solve</source>
        <translation>풀이</translation>
    </message>
    <message>
        <source>project %1 vertices</source>
        <translation>정점 %1개 투영</translation>
    </message>
    <message>
        <source>order points</source>
        <translation>점 정렬</translation>
    </message>
    <message>
        <source>make triangles</source>
        <translation>삼각형 만들기</translation>
    </message>
    <message>
        <source>make surface</source>
        <translation>서피스 만들기</translation>
    </message>
    <message>
        <source>make surface with smaller cells</source>
        <translation>더 작은 셀로 서피스 만들기</translation>
    </message>
    <message>
        <source>make pieces</source>
        <translation>조각 만들기</translation>
    </message>
    <message>
        <source>inspect</source>
        <translation>검사</translation>
    </message>
    <message>
        <source>improve</source>
        <translation>개선</translation>
    </message>
    <message>
        <source>find the curves</source>
        <translation>커브 찾기</translation>
    </message>
    <message>
        <source>find the camera</source>
        <translation>카메라 찾기</translation>
    </message>
    <message>
        <source>find the vertices</source>
        <translation>정점 찾기</translation>
    </message>
    <message>
        <source>find the faces</source>
        <translation>페이스 찾기</translation>
    </message>
    <message>
        <source>find self-intersections</source>
        <translation>자체 교차 찾기</translation>
    </message>
    <message>
        <source>find rims</source>
        <translation>구멍 가장자리 찾기</translation>
    </message>
    <message>
        <source>find lines</source>
        <translation>선 찾기</translation>
    </message>
    <message>
        <source>find holes</source>
        <translation>구멍 찾기</translation>
    </message>
    <message>
        <source>find loops</source>
        <translation>루프 찾기</translation>
    </message>
    <message>
        <source>choose faces</source>
        <translation>페이스 선택</translation>
    </message>
    <message>
        <source>evaluate the network</source>
        <translation>네트워크 계산</translation>
    </message>
    <message>
        <source>count elements</source>
        <translation>요소 세기</translation>
    </message>
    <message>
        <source>compare surfaces</source>
        <translation>서피스 비교</translation>
    </message>
    <message>
        <source>compare patches</source>
        <translation>패치 비교</translation>
    </message>
    <message>
        <source>carry over attributes</source>
        <translation>속성 옮기기</translation>
    </message>
    <message>
        <source>analyse holes</source>
        <translation>구멍 분석</translation>
    </message>
    <message>
        <source>write STEP</source>
        <translation>STEP 쓰기</translation>
    </message>
    <message>
        <source>trim rims</source>
        <translation>구멍 가장자리 다듬기</translation>
    </message>
    <message>
        <source>trace lines</source>
        <translation>선 트레이스</translation>
    </message>
    <message>
        <source>separating parts</source>
        <translation>부위 분리</translation>
    </message>
    <message>
        <source>search intersections</source>
        <translation>교차 탐색</translation>
    </message>
    <message>
        <source>sample sheets</source>
        <translation>면 샘플링</translation>
    </message>
    <message>
        <source>measure openings</source>
        <translation>열린 곳 측정</translation>
    </message>
    <message>
        <source>measure holes</source>
        <translation>구멍 측정</translation>
    </message>
    <message>
        <source>make quads</source>
        <translation>사각형 만들기</translation>
    </message>
    <message>
        <source>make quads %1 of %2</source>
        <translation>사각형 만들기 %1/%2</translation>
    </message>
    <message>
        <source>make patches</source>
        <translation>패치 만들기</translation>
    </message>
    <message>
        <source>make patches %1 of %2</source>
        <translation>패치 만들기 %1/%2</translation>
    </message>
    <message>
        <source>make triangles %1 of %2</source>
        <translation>삼각형 만들기 %1/%2</translation>
    </message>
    <message>
        <source>make about %1 faces</source>
        <translation>페이스 약 %1개 만들기</translation>
    </message>
    <message>
        <source>limit of the surface</source>
        <translation>서피스의 극한 계산</translation>
    </message>
    <message>
        <source>limit beside sharp edges</source>
        <translation>날카로운 에지 옆의 극한 계산</translation>
    </message>
    <message>
        <source>lift the curves</source>
        <translation>커브를 공간으로 옮기기</translation>
    </message>
    <message>
        <source>join pieces</source>
        <translation>조각 연결</translation>
    </message>
    <message>
        <source>inflate part</source>
        <translation>부위 부풀리기</translation>
    </message>
    <message>
        <source>fit surfaces</source>
        <translation>서피스 맞추기</translation>
    </message>
    <message>
        <source>fit surfaces %1 of %2</source>
        <translation>서피스 맞추기 %1/%2</translation>
    </message>
    <message>
        <source>fit functions</source>
        <translation>함수 맞추기</translation>
    </message>
    <message>
        <source>fit %1 domains</source>
        <translation>도메인 %1개 맞추기</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>마무리</translation>
    </message>
    <message>
        <source>evaluate</source>
        <translation>계산</translation>
    </message>
    <message>
        <source>enter slab</source>
        <translation>구간 계산</translation>
    </message>
    <message>
        <source>drop detached sheets</source>
        <translation>떨어진 면 제거</translation>
    </message>
    <message>
        <source>count parts and handles</source>
        <translation>부분과 핸들 세기</translation>
    </message>
    <message>
        <source>cut space</source>
        <translation>공간 나누기</translation>
    </message>
    <message>
        <source>close openings by patches</source>
        <translation>열린 곳을 패치로 닫기</translation>
    </message>
    <message>
        <source>carve details</source>
        <translation>디테일 새기기</translation>
    </message>
    <message>
        <source>build the solid</source>
        <translation>솔리드 만들기</translation>
    </message>
    <message>
        <source>skeleton</source>
        <translation>골격 계산</translation>
    </message>
    <message>
        <source>measure</source>
        <translation>측정</translation>
    </message>
    <message>
        <source>intersections</source>
        <translation>교차 검사</translation>
    </message>
    <message>
        <source>label</source>
        <translation>선 분석</translation>
    </message>
    <message>
        <source>mid-surface</source>
        <translation>중간 서피스 계산</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>두께 계산</translation>
    </message>
    <message>
        <source>curvature</source>
        <translation>곡률 계산</translation>
    </message>
    <message>
        <source>prepare</source>
        <translation>준비</translation>
    </message>
    <message>
        <source>'%1', line %2</source>
        <translation>'%1' %2행</translation>
    </message>
    <message>
        <source>'%1', byte %2</source>
        <translation>'%1' %2바이트</translation>
    </message>
    <message>
        <source>%1 more findings of this kind are not listed</source>
        <translation>같은 종류의 검사 결과 %1개는 표시하지 않습니다</translation>
    </message>
    <message>
        <source>%1 more findings of the kind %2 are not listed</source>
        <translation>%2 종류의 검사 결과 %1개는 표시하지 않습니다</translation>
    </message>
    <message>
        <source>The file '%1' can't be read: %2.</source>
        <translation>파일 '%1'을(를) 읽을 수 없습니다: %2.</translation>
    </message>
    <message>
        <source>The file '%1' can't be written: %2.</source>
        <translation>파일 '%1'에 쓸 수 없습니다: %2.</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>그런 파일이 없습니다</translation>
    </message>
    <message>
        <source>you have no permission to read it</source>
        <translation>읽기 권한이 없습니다</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>폴더입니다</translation>
    </message>
    <message>
        <source>a part of its path is not a folder</source>
        <translation>경로의 일부가 폴더가 아닙니다</translation>
    </message>
    <message>
        <source>its folder does not exist</source>
        <translation>폴더가 존재하지 않습니다</translation>
    </message>
    <message>
        <source>you have no permission to write there</source>
        <translation>그곳에 쓰기 권한이 없습니다</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>디스크가 가득 찼습니다</translation>
    </message>
    <message>
        <source>it is a device or pipe</source>
        <translation>장치나 파이프입니다</translation>
    </message>
    <message>
        <source>it is named for two different outputs</source>
        <translation>서로 다른 두 출력에 지정되었습니다</translation>
    </message>
    <message>
        <source>no temporary file could be made in its folder</source>
        <translation>폴더에 임시 파일을 만들 수 없습니다</translation>
    </message>
    <message>
        <source>no name is free beside it for the damaged version</source>
        <translation>손상된 버전을 보관할 이름이 없습니다</translation>
    </message>
    <message>
        <source>no name is free in it</source>
        <translation>사용할 수 있는 이름이 없습니다</translation>
    </message>
    <message>
        <source>The file '%1' is empty.</source>
        <translation>파일 '%1'이(가) 비어 있습니다.</translation>
    </message>
    <message>
        <source>'%1': lists and objects are nested deeper than %2 levels.</source>
        <translation>'%1': 목록과 객체가 %2단계보다 깊이 중첩되어 있습니다.</translation>
    </message>
    <message>
        <source>%1: %2 %3 were passed over: %4 has no such member.</source>
        <translation>%1: %3 %2개를 건너뛰었습니다. %4에 그런 항목이 없습니다.</translation>
    </message>
    <message>
        <source>'%1' of %2</source>
        <translation>%2의 '%1'</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>파일이 비어 있습니다</translation>
    </message>
    <message>
        <source>'%1': files of 4 GiB and more are not read; split the model.</source>
        <translation>'%1': 4 GiB 이상의 파일은 읽지 않습니다. 모델을 나누세요.</translation>
    </message>
    <message>
        <source>'%1': its nodes repeat its meshes more often than is read; export fewer copies.</source>
        <translation>'%1': 노드가 메쉬를 너무 많이 반복합니다. 복사본을 줄여 내보내세요.</translation>
    </message>
    <message>
        <source>face %1 uses a vertex twice; it is kept as it is</source>
        <translation>페이스 %1이(가) 한 정점을 두 번 사용합니다. 그대로 유지합니다</translation>
    </message>
    <message>
        <source>%1 faces use a vertex twice, the first is face %2; they are kept as they are</source>
        <translation>페이스 %1개가 한 정점을 두 번 사용하며 첫 번째는 페이스 %2입니다. 그대로 유지합니다</translation>
    </message>
    <message>
        <source>the file has %1 vertices and %2 polylines, but no faces</source>
        <translation>파일에 정점 %1개와 폴리라인 %2개가 있지만 페이스가 없습니다</translation>
    </message>
    <message>
        <source>the file has no vertices</source>
        <translation>파일에 정점이 없습니다</translation>
    </message>
    <message>
        <source>all points of the model are the same</source>
        <translation>모델의 모든 점이 같습니다</translation>
    </message>
    <message>
        <source>vertex %1 has a coordinate that isn't finite or is larger than 1e30</source>
        <translation>정점 %1의 좌표가 유한하지 않거나 1e30보다 큽니다</translation>
    </message>
    <message>
        <source>vertex %1 has a coordinate that isn't finite or is larger than 1e30; repair it or drop it</source>
        <translation>정점 %1의 좌표가 유한하지 않거나 1e30보다 큽니다. 고치거나 제거하세요</translation>
    </message>
    <message>
        <source>face %1 uses vertex %2, but the file has %3 vertices</source>
        <translation>페이스 %1이(가) 정점 %2을(를) 사용하지만 파일의 정점은 %3개입니다</translation>
    </message>
    <message>
        <source>face %1 has %2 corners, and a face needs at least 3</source>
        <translation>페이스 %1의 꼭짓점이 %2개인데 페이스에는 3개 이상 필요합니다</translation>
    </message>
    <message>
        <source>%1 can't hold %2.</source>
        <translation>%1 형식에는 %2을(를) 담을 수 없습니다.</translation>
    </message>
    <message>
        <source>normals</source>
        <translation>노멀</translation>
    </message>
    <message>
        <source>colours</source>
        <translation>색상</translation>
    </message>
    <message>
        <source>places in textures</source>
        <translation>텍스처 좌표</translation>
    </message>
    <message>
        <source>names of objects</source>
        <translation>오브젝트 이름</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>그룹</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>머티리얼</translation>
    </message>
    <message>
        <source>corners</source>
        <translation>꼭짓점</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>선</translation>
    </message>
    <message>
        <source>the attribute '%1' of %2</source>
        <translation>%2의 속성 '%1'</translation>
    </message>
    <message>
        <source>polygons (they are cut into triangles)</source>
        <translation>폴리곤(삼각형으로 나눕니다)</translation>
    </message>
    <message>
        <source>polylines (they are cut into edges)</source>
        <translation>폴리라인(에지로 나눕니다)</translation>
    </message>
    <message>
        <source>tags (%1 and %2)</source>
        <translation>태그(%1, %2)</translation>
    </message>
    <message>
        <source>1 sharp edge</source>
        <translation>날카로운 에지 1개</translation>
    </message>
    <message>
        <source>%1 sharp edges</source>
        <translation>날카로운 에지 %1개</translation>
    </message>
    <message>
        <source>1 set of tags (%1; the tags are kept)</source>
        <translation>태그 세트 1개(%1, 태그는 유지됩니다)</translation>
    </message>
    <message>
        <source>%1 sets of tags (%2; the tags are kept)</source>
        <translation>태그 세트 %1개(%2, 태그는 유지됩니다)</translation>
    </message>
    <message>
        <source>the names of '%1' (their numbers are kept)</source>
        <translation>'%1'의 이름(번호는 유지됩니다)</translation>
    </message>
    <message>
        <source>the order of vertices</source>
        <translation>정점의 순서</translation>
    </message>
    <message>
        <source>Vertex %1 is too far out for the 32-bit numbers of %2; scale the model down or write another format.</source>
        <translation>정점 %1이(가) %2의 32비트 숫자로 나타내기에 너무 멀리 있습니다. 모델을 줄이거나 다른 형식으로 쓰세요.</translation>
    </message>
    <message>
        <source>The mesh has no faces, and STL holds nothing else: write it as PLY or OBJ</source>
        <translation>메쉬에 페이스가 없는데 STL에는 페이스만 담을 수 있습니다. PLY나 OBJ로 쓰세요</translation>
    </message>
    <message>
        <source>it is not an object</source>
        <translation>객체가 아닙니다</translation>
    </message>
    <message>
        <source>it is no JSON object</source>
        <translation>JSON 객체가 아닙니다</translation>
    </message>
    <message>
        <source>its format is not "%1"</source>
        <translation>형식이 "%1"이(가) 아닙니다</translation>
    </message>
    <message>
        <source>it is not "%1"</source>
        <translation>"%1"이(가) 아닙니다</translation>
    </message>
    <message>
        <source>%1 is not a list</source>
        <translation>%1이(가) 목록이 아닙니다</translation>
    </message>
    <message>
        <source>its id is not a text</source>
        <translation>id가 텍스트가 아닙니다</translation>
    </message>
    <message>
        <source>%1 isn't finite or is larger than 1e30</source>
        <translation>%1이(가) 유한하지 않거나 1e30보다 큽니다</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1이(가) 숫자가 아닙니다</translation>
    </message>
    <message>
        <source>%1 is not a list of three numbers</source>
        <translation>%1이(가) 숫자 세 개의 목록이 아닙니다</translation>
    </message>
    <message>
        <source>%1 is not a list of points</source>
        <translation>%1이(가) 점의 목록이 아닙니다</translation>
    </message>
    <message>
        <source>its %1 is not %2</source>
        <translation>%1이(가) %2이(가) 아닙니다</translation>
    </message>
    <message>
        <source>its %1 is not a text</source>
        <translation>%1이(가) 텍스트가 아닙니다</translation>
    </message>
    <message>
        <source>its %1 is not an id</source>
        <translation>%1이(가) id가 아닙니다</translation>
    </message>
    <message>
        <source>it refers to node "%1", which isn't there: add it or correct the name</source>
        <translation>존재하지 않는 노드 "%1"을(를) 참조합니다. 추가하거나 이름을 고치세요</translation>
    </message>
    <message>
        <source>it refers to curve "%1", which isn't there: add it or correct the name</source>
        <translation>존재하지 않는 커브 "%1"을(를) 참조합니다. 추가하거나 이름을 고치세요</translation>
    </message>
    <message>
        <source>it refers to face "%1", which isn't there: add it or correct the name</source>
        <translation>존재하지 않는 페이스 "%1"을(를) 참조합니다. 추가하거나 이름을 고치세요</translation>
    </message>
    <message>
        <source>its ctrl has no points</source>
        <translation>ctrl에 점이 없습니다</translation>
    </message>
    <message>
        <source>its loop is not a list of curves with signs</source>
        <translation>loop가 부호가 있는 커브의 목록이 아닙니다</translation>
    </message>
    <message>
        <source>its fan is not a list of a corner and two numbers</source>
        <translation>fan이 코너 하나와 숫자 두 개의 목록이 아닙니다</translation>
    </message>
    <message>
        <source>at of its slope is not a list of numbers</source>
        <translation>기울기의 at이 숫자 목록이 아닙니다</translation>
    </message>
    <message>
        <source>%1 is not a number above 0</source>
        <translation>%1이(가) 0보다 큰 숫자가 아닙니다</translation>
    </message>
    <message>
        <source>%1 is not a list of %2 numbers</source>
        <translation>%1이(가) 숫자 %2개의 목록이 아닙니다</translation>
    </message>
    <message>
        <source>%1 is not a list of %2 rows</source>
        <translation>%1이(가) 행 %2개의 목록이 아닙니다</translation>
    </message>
    <message>
        <source>%1 is not a rotation</source>
        <translation>%1이(가) 회전이 아닙니다</translation>
    </message>
    <message>
        <source>image is not two numbers above 0</source>
        <translation>image가 0보다 큰 숫자 두 개가 아닙니다</translation>
    </message>
    <message>
        <source>it holds no camera: rotation or viewTransform is missing</source>
        <translation>카메라가 없습니다. rotation이나 viewTransform이 없습니다</translation>
    </message>
    <message>
        <source>principalPoint is not an object with x and y</source>
        <translation>principalPoint가 x와 y가 있는 객체가 아닙니다</translation>
    </message>
    <message>
        <source>horizontalFieldOfView is not an angle below pi</source>
        <translation>horizontalFieldOfView가 파이보다 작은 각도가 아닙니다</translation>
    </message>
    <message>
        <source>the fSpy project ends within its head of 16 bytes</source>
        <translation>fSpy 프로젝트가 16바이트 머리글 안에서 끝납니다</translation>
    </message>
    <message>
        <source>the fSpy project is of version %1, only 1 can be read: export it as JSON</source>
        <translation>fSpy 프로젝트의 버전이 %1인데 1만 읽을 수 있습니다. JSON으로 내보내세요</translation>
    </message>
    <message>
        <source>the fSpy project ends before its %1 bytes of JSON do</source>
        <translation>fSpy 프로젝트가 JSON %1바이트보다 먼저 끝납니다</translation>
    </message>
    <message>
        <source>the fSpy project has no camera: fSpy found none</source>
        <translation>fSpy 프로젝트에 카메라가 없습니다. fSpy가 찾지 못했습니다</translation>
    </message>
    <message>
        <source>it is not %1</source>
        <translation>%1이(가) 아닙니다</translation>
    </message>
    <message>
        <source>true or false, a number or a text</source>
        <translation>true, false, 숫자 또는 텍스트</translation>
    </message>
    <message>
        <source>the size of the sheet is missing</source>
        <translation>용지의 크기가 없습니다</translation>
    </message>
    <message>
        <source>width and height are not positive</source>
        <translation>너비와 높이가 양수가 아닙니다</translation>
    </message>
    <message>
        <source>an object with at and point</source>
        <translation>at과 point가 있는 객체</translation>
    </message>
    <message>
        <source>a list of strokes with their lengths above 0</source>
        <translation>0보다 큰 길이가 있는 획의 목록</translation>
    </message>
    <message>
        <source>a number between 0 and 180</source>
        <translation>0과 180 사이의 숫자</translation>
    </message>
    <message>
        <source>a list of two numbers</source>
        <translation>숫자 두 개의 목록</translation>
    </message>
    <message>
        <source>a whole number above 0</source>
        <translation>0보다 큰 정수</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>0보다 큰 숫자</translation>
    </message>
    <message>
        <source>it is not a list</source>
        <translation>목록이 아닙니다</translation>
    </message>
    <message>
        <source>there are none: there is nothing to make a solid of</source>
        <translation>하나도 없습니다. 솔리드를 만들 것이 없습니다</translation>
    </message>
    <message>
        <source>another stroke has the name '%1'</source>
        <translation>다른 획의 이름이 '%1'입니다</translation>
    </message>
    <message>
        <source>it is not a text</source>
        <translation>텍스트가 아닙니다</translation>
    </message>
    <message>
        <source>a number from 0 to 5</source>
        <translation>0에서 5 사이의 숫자</translation>
    </message>
    <message>
        <source>it is not a list of points</source>
        <translation>점의 목록이 아닙니다</translation>
    </message>
    <message>
        <source>it is not a list of two points</source>
        <translation>점 두 개의 목록이 아닙니다</translation>
    </message>
    <message>
        <source>it is not a list of cubics with four points each</source>
        <translation>점이 네 개씩인 3차 커브의 목록이 아닙니다</translation>
    </message>
    <message>
        <source>a piece doesn't begin where the one before ended</source>
        <translation>조각이 앞 조각이 끝난 곳에서 시작하지 않습니다</translation>
    </message>
    <message>
        <source>Stroke '%1' has %2='%3', which isn't understood and was ignored</source>
        <translation>획 '%1'의 %2='%3'을(를) 이해할 수 없어 무시했습니다</translation>
    </message>
    <message>
        <source>Stroke '%1' is of group %2 although its colour is that of group %3: change one of them if that isn't meant</source>
        <translation>획 '%1'의 그룹은 %2인데 색은 그룹 %3의 색입니다. 의도한 것이 아니면 하나를 바꾸세요</translation>
    </message>
    <message>
        <source>The drawing has no viewBox: its sheet was taken to end where the strokes end, so the eye point may be off</source>
        <translation>드로잉에 viewBox가 없어 획이 끝나는 곳을 용지의 끝으로 보았습니다. 시점이 어긋날 수 있습니다</translation>
    </message>
    <message>
        <source>The element '%1' isn't understood and was ignored</source>
        <translation>요소 '%1'을(를) 이해할 수 없어 무시했습니다</translation>
    </message>
    <message>
        <source>The drawing's data-plane is no plane: it takes nine numbers, an origin and two directions of length 1 at a right angle</source>
        <translation>드로잉의 data-plane이 평면이 아닙니다. 원점과, 길이가 1이고 서로 직각인 두 방향을 나타내는 숫자 아홉 개가 필요합니다</translation>
    </message>
    <message>
        <source>Stroke '%1' is a single point and was ignored</source>
        <translation>획 '%1'이(가) 점 하나뿐이어서 무시했습니다</translation>
    </message>
    <message>
        <source>Stroke '%1' on line %2 has a coordinate that isn't finite or is larger than 1e30</source>
        <translation>%2행에 있는 획 '%1'의 좌표가 유한하지 않거나 1e30보다 큽니다</translation>
    </message>
    <message>
        <source>The rectangle '%1' behind the drawing has no line and was ignored</source>
        <translation>드로잉 뒤의 사각형 '%1'에 선이 없어 무시했습니다</translation>
    </message>
    <message>
        <source>The drawing has more than 4 million samples: simplify it</source>
        <translation>드로잉의 샘플이 400만 개를 넘습니다. 단순화하세요</translation>
    </message>
    <message>
        <source>The drawing has no visible path, line or other shape: there is nothing to make a solid of</source>
        <translation>드로잉에 보이는 경로나 선, 도형이 없습니다. 솔리드를 만들 것이 없습니다</translation>
    </message>
    <message>
        <source>The file is empty</source>
        <translation>파일이 비어 있습니다</translation>
    </message>
    <message>
        <source>The file is not text in UTF-8: it has a zero byte</source>
        <translation>파일이 UTF-8 텍스트가 아닙니다. 값이 0인 바이트가 있습니다</translation>
    </message>
    <message>
        <source>The file is not well-formed XML on line %1: %2</source>
        <translation>파일의 %1행이 올바른 XML이 아닙니다: %2</translation>
    </message>
    <message>
        <source>The file is not SVG: its outermost element is '%1'</source>
        <translation>파일이 SVG가 아닙니다. 가장 바깥 요소가 '%1'입니다</translation>
    </message>
    <message>
        <source>A second stroke named '%1' is called '%2' here</source>
        <translation>이름이 '%1'인 두 번째 획을 여기서는 '%2'(으)로 부릅니다</translation>
    </message>
    <message>
        <source>The strokes' names and data attributes exceed 64 MiB</source>
        <translation>획의 이름과 데이터 속성이 64 MiB를 넘습니다</translation>
    </message>
    <message>
        <source>has '%1' where a command must stand</source>
        <translation>명령이 있어야 할 곳에 '%1'이(가) 있습니다</translation>
    </message>
    <message>
        <source>must begin with a moveto (M or m)</source>
        <translation>moveto(M 또는 m)로 시작해야 합니다</translation>
    </message>
    <message>
        <source>has a comma without a number after it</source>
        <translation>쉼표 뒤에 숫자가 없습니다</translation>
    </message>
    <message>
        <source>has an arc flag that is neither 0 nor 1</source>
        <translation>호 플래그가 0도 1도 아닙니다</translation>
    </message>
    <message>
        <source>lacks a number for its command %1</source>
        <translation>명령 %1에 숫자가 부족합니다</translation>
    </message>
    <message>
        <source>has too many pieces</source>
        <translation>조각이 너무 많습니다</translation>
    </message>
    <message>
        <source>needs pairs of numbers</source>
        <translation>숫자의 쌍이 필요합니다</translation>
    </message>
    <message>
        <source>has too many points</source>
        <translation>점이 너무 많습니다</translation>
    </message>
    <message>
        <source>has a transform that is not understood, '%1'</source>
        <translation>이해할 수 없는 변환 '%1'이(가) 있습니다</translation>
    </message>
    <message>
        <source>has a negative radius</source>
        <translation>반지름이 음수입니다</translation>
    </message>
    <message>
        <source>has a negative width or height</source>
        <translation>너비나 높이가 음수입니다</translation>
    </message>
    <message>
        <source>has %1='%2', which is no length</source>
        <translation>%1='%2'이(가) 길이가 아닙니다</translation>
    </message>
    <message>
        <source>1 '%1' element was ignored: turn text into paths to make it strokes</source>
        <translation>'%1' 요소 1개를 무시했습니다. 획으로 만들려면 텍스트를 경로로 변환하세요</translation>
    </message>
    <message>
        <source>%1 '%2' elements were ignored: turn text into paths to make it strokes</source>
        <translation>'%2' 요소 %1개를 무시했습니다. 획으로 만들려면 텍스트를 경로로 변환하세요</translation>
    </message>
    <message>
        <source>1 '%1' element was ignored: only lines are read</source>
        <translation>'%1' 요소 1개를 무시했습니다. 선만 읽습니다</translation>
    </message>
    <message>
        <source>%1 '%2' elements were ignored: only lines are read</source>
        <translation>'%2' 요소 %1개를 무시했습니다. 선만 읽습니다</translation>
    </message>
    <message>
        <source>The drawing is nested deeper than %1 groups: ungroup it</source>
        <translation>드로잉의 그룹이 %1단계보다 깊이 중첩되어 있습니다. 그룹을 해제하세요</translation>
    </message>
    <message>
        <source>A use element was ignored, for the drawing has no element '%1'</source>
        <translation>드로잉에 요소 '%1'이(가) 없어 use 요소를 무시했습니다</translation>
    </message>
    <message>
        <source>The use element on line %1 shows '%2', which it is a part of itself</source>
        <translation>%1행의 use 요소가 자신이 속한 '%2'을(를) 표시합니다</translation>
    </message>
    <message>
        <source>The drawing shows elements by use more than 100,000 times</source>
        <translation>드로잉이 use로 요소를 100,000번 넘게 표시합니다</translation>
    </message>
    <message>
        <source>A path of the drawing has more than 4 million pieces: simplify it</source>
        <translation>드로잉의 경로 하나가 400만 조각을 넘습니다. 단순화하세요</translation>
    </message>
    <message>
        <source>Stroke '%1' on line %2 %3 (character %4 of its %5)</source>
        <translation>%2행의 획 '%1': %3(%5의 %4번째 글자)</translation>
    </message>
    <message>
        <source>A group on line %1 %2 (character %3 of its %4)</source>
        <translation>%1행의 그룹: %2(%4의 %3번째 글자)</translation>
    </message>
    <message>
        <source>The group '%1' on line %2 %3 (character %4 of its %5)</source>
        <translation>%2행의 그룹 '%1': %3(%5의 %4번째 글자)</translation>
    </message>
    <message>
        <source>The picture "%1" can't be read: %2; save it again as PNG</source>
        <translation>이미지 "%1"을(를) 읽을 수 없습니다: %2. PNG로 다시 저장하세요</translation>
    </message>
    <message>
        <source>The picture "%1" has more than 100 million pixels: scale it down</source>
        <translation>이미지 "%1"의 픽셀이 1억 개를 넘습니다. 크기를 줄이세요</translation>
    </message>
    <message>
        <source>The picture "%1" shows more than a line drawing does: take a picture of the drawing alone, or draw over it in the studio</source>
        <translation>이미지 "%1"에 선 드로잉 말고 다른 것이 보입니다. 드로잉만 찍거나 이미지 위에 직접 그리세요</translation>
    </message>
    <message>
        <source>The picture "%1" has no line in it: draw with a darker pen, or take the picture nearer and in more light</source>
        <translation>이미지 "%1"에 선이 없습니다. 더 진한 펜으로 그리거나 더 가까이, 더 밝은 곳에서 찍으세요</translation>
    </message>
    <message>
        <source>The picture "%1" isn't a PNG file, the only pictures that are read here: save it as PNG, or open it in the studio</source>
        <translation>이미지 "%1"은(는) PNG 파일이 아닙니다. PNG로 저장하거나 스튜디오에서 여세요</translation>
    </message>
    <message>
        <source>The project '%1' is damaged: %2; no earlier versions lie beside it.</source>
        <translation>프로젝트 '%1'이(가) 손상되었습니다: %2. 같은 폴더에 이전 버전이 없습니다.</translation>
    </message>
    <message>
        <source>The project '%1' is damaged: %2; open an earlier version beside it: %3.</source>
        <translation>프로젝트 '%1'이(가) 손상되었습니다: %2. 같은 폴더의 이전 버전을 여세요: %3.</translation>
    </message>
    <message>
        <source>The project '%1' is damaged and can't be opened: %2; no earlier versions lie beside it.</source>
        <translation>프로젝트 '%1'이(가) 손상되어 열 수 없습니다: %2. 같은 폴더에 이전 버전이 없습니다.</translation>
    </message>
    <message>
        <source>The project '%1' is damaged and can't be opened: %2; open an earlier version beside it: %3.</source>
        <translation>프로젝트 '%1'이(가) 손상되어 열 수 없습니다: %2. 같은 폴더의 이전 버전을 여세요: %3.</translation>
    </message>
    <message>
        <source>it is incomplete</source>
        <translation>불완전합니다</translation>
    </message>
    <message>
        <source>they are missing</source>
        <translation>데이터가 없습니다</translation>
    </message>
    <message>
        <source>a part of them is missing</source>
        <translation>데이터의 일부가 없습니다</translation>
    </message>
    <message>
        <source>they have changed since they were saved</source>
        <translation>저장한 뒤 데이터가 바뀌었습니다</translation>
    </message>
    <message>
        <source>its bytes aren't those that were saved</source>
        <translation>저장할 때의 데이터와 다릅니다</translation>
    </message>
    <message>
        <source>some of its bytes aren't those that were saved</source>
        <translation>일부가 저장할 때의 데이터와 다릅니다</translation>
    </message>
    <message>
        <source>its parts lead back into each other</source>
        <translation>부분들이 서로를 되풀이해 가리킵니다</translation>
    </message>
    <message>
        <source>its parts overlap</source>
        <translation>부분들이 겹칩니다</translation>
    </message>
    <message>
        <source>node %1 ('%2')</source>
        <translation>노드 %1('%2')</translation>
    </message>
    <message>
        <source>%1 has values that can't be and is left out</source>
        <translation>%1의 값이 올바르지 않아 제외합니다</translation>
    </message>
    <message>
        <source>%1 has lost its parameter '%2'</source>
        <translation>%1의 매개변수 '%2'을(를) 잃었습니다</translation>
    </message>
    <message>
        <source>%1 has lost its input '%2'</source>
        <translation>%1의 입력 '%2'을(를) 잃었습니다</translation>
    </message>
    <message>
        <source>%1 has lost its transform</source>
        <translation>%1의 변환을 잃었습니다</translation>
    </message>
    <message>
        <source>%1 has lost its place</source>
        <translation>%1의 위치를 잃었습니다</translation>
    </message>
    <message>
        <source>%1 has lost the picture behind it</source>
        <translation>%1의 밑그림 이미지를 잃었습니다</translation>
    </message>
    <message>
        <source>%1 has lost the picture behind it: its place or opacity can't be</source>
        <translation>%1의 밑그림 이미지를 잃었습니다. 위치나 불투명도가 올바르지 않습니다</translation>
    </message>
    <message>
        <source>%1 has lost the picture behind it: %2</source>
        <translation>%1의 밑그림 이미지를 잃었습니다: %2</translation>
    </message>
    <message>
        <source>%1 is of a kind that this version doesn't know and is left out</source>
        <translation>%1은(는) 이 버전에서 알 수 없는 종류여서 제외합니다</translation>
    </message>
    <message>
        <source>%1 is left out since its contents can't be read: %2</source>
        <translation>%1의 내용을 읽을 수 없어 제외합니다: %2</translation>
    </message>
    <message>
        <source>not all of its %1 can be read</source>
        <translation>다음 중 일부를 읽을 수 없습니다: %1</translation>
    </message>
    <message>
        <source>objects and steps</source>
        <translation>오브젝트와 단계</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>매개변수</translation>
    </message>
    <message>
        <source>links between steps</source>
        <translation>단계 사이의 연결</translation>
    </message>
    <message>
        <source>drawings and meshes</source>
        <translation>드로잉과 메쉬</translation>
    </message>
    <message>
        <source>places in space</source>
        <translation>공간 위치</translation>
    </message>
    <message>
        <source>steps that are off</source>
        <translation>꺼진 단계</translation>
    </message>
    <message>
        <source>pictures behind drawings</source>
        <translation>밑그림 이미지</translation>
    </message>
    <message>
        <source>objects</source>
        <translation>오브젝트</translation>
    </message>
    <message>
        <source>contents</source>
        <translation>내용</translation>
    </message>
    <message>
        <source>pages</source>
        <translation>페이지</translation>
    </message>
    <message>
        <source>kept_results</source>
        <translation>보관된 결과</translation>
    </message>
    <message>
        <source>past</source>
        <translation>작업 내역</translation>
    </message>
    <message>
        <source>past_nodes</source>
        <translation>작업 내역의 노드</translation>
    </message>
    <message>
        <source>a flag is neither 0 nor 1</source>
        <translation>플래그가 0도 1도 아닙니다</translation>
    </message>
    <message>
        <source>it is no place</source>
        <translation>위치가 아닙니다</translation>
    </message>
    <message>
        <source>a parameter is of no known type</source>
        <translation>매개변수의 유형을 알 수 없습니다</translation>
    </message>
    <message>
        <source>a value is of no known type</source>
        <translation>값의 유형을 알 수 없습니다</translation>
    </message>
    <message>
        <source>The file '%1' is not a Croquis project; give a .croq file.</source>
        <translation>파일 '%1'은(는) Croquis 프로젝트가 아닙니다. .croq 파일을 사용하세요.</translation>
    </message>
    <message>
        <source>its thumbnail can't be read</source>
        <translation>썸네일을 읽을 수 없습니다</translation>
    </message>
    <message>
        <source>The project '%1' was saved by a newer Croquis (schema %2, this one knows %3); open it with that version.</source>
        <translation>프로젝트 '%1'은(는) 더 새로운 Croquis로 저장되었습니다(스키마 %2, 이 버전은 %3까지). 그 버전으로 여세요.</translation>
    </message>
    <message>
        <source>The project '%1' was saved by a newer Croquis (schema %2, this one knows %3); what this version doesn't know is left out when you save it.</source>
        <translation>프로젝트 '%1'은(는) 더 새로운 Croquis로 저장되었습니다(스키마 %2, 이 버전은 %3까지). 저장하면 이 버전에서 알 수 없는 것은 빠집니다.</translation>
    </message>
    <message>
        <source>its table '%1' is not a stored one</source>
        <translation>테이블 '%1'이(가) 저장된 테이블이 아닙니다</translation>
    </message>
    <message>
        <source>The project '%1' has tables that mean nothing to this version (%2); they are left out when you save it.</source>
        <translation>프로젝트 '%1'에 이 버전에서 알 수 없는 테이블(%2)이 있습니다. 저장하면 빠집니다.</translation>
    </message>
    <message>
        <source>names, parameters or links are not those that were saved, so check them before you continue</source>
        <translation>이름, 매개변수, 연결이 저장할 때와 다릅니다. 계속하기 전에 확인하세요</translation>
    </message>
    <message>
        <source>a kept result is of a kind that this version doesn't know</source>
        <translation>보관된 결과의 종류를 이 버전에서 알 수 없습니다</translation>
    </message>
    <message>
        <source>a kept result can't be read: %1</source>
        <translation>보관된 결과를 읽을 수 없습니다: %1</translation>
    </message>
    <message>
        <source>the steps that could be undone can't be read</source>
        <translation>실행 취소할 수 있던 단계를 읽을 수 없습니다</translation>
    </message>
    <message>
        <source>of tags only crease and corner are read</source>
        <translation>태그는 crease와 corner만 읽습니다</translation>
    </message>
    <message>
        <source>the material library is not read, material names are kept</source>
        <translation>머티리얼 라이브러리는 읽지 않고 머티리얼 이름은 유지합니다</translation>
    </message>
    <message>
        <source>points as elements are not read</source>
        <translation>점 요소는 읽지 않습니다</translation>
    </message>
    <message>
        <source>they say nothing that a mesh holds</source>
        <translation>메쉬에 담기는 내용이 아닙니다</translation>
    </message>
    <message>
        <source>%1 statements were passed over: %2</source>
        <translation>%1 명령을 건너뛰었습니다. %2</translation>
    </message>
    <message>
        <source>'%1' is not the counts of a tag, such as 2/1/0</source>
        <translation>'%1'은(는) 2/1/0 같은 태그의 개수가 아닙니다</translation>
    </message>
    <message>
        <source>the tag has fewer values than it announces</source>
        <translation>태그의 값이 알린 것보다 적습니다</translation>
    </message>
    <message>
        <source>the tag has more values than it announces</source>
        <translation>태그의 값이 알린 것보다 많습니다</translation>
    </message>
    <message>
        <source>'%1' is not a vertex number</source>
        <translation>'%1'은(는) 정점 번호가 아닙니다</translation>
    </message>
    <message>
        <source>'%1' is not a sharpness</source>
        <translation>'%1'은(는) 날카로움 값이 아닙니다</translation>
    </message>
    <message>
        <source>vertex %1 has the sharpness %2, but vertices are pinned or not: it is pinned</source>
        <translation>정점 %1의 날카로움이 %2인데 정점은 고정되거나 고정되지 않을 뿐입니다. 고정했습니다</translation>
    </message>
    <message>
        <source>vertex %1 has the sharpness %2 and is not pinned</source>
        <translation>정점 %1의 날카로움이 %2(이)어서 고정하지 않았습니다</translation>
    </message>
    <message>
        <source>there are more than %1 numbers</source>
        <translation>숫자가 %1개를 넘습니다</translation>
    </message>
    <message>
        <source>'%1' is not a number</source>
        <translation>'%1'은(는) 숫자가 아닙니다</translation>
    </message>
    <message>
        <source>'%1' is not a vertex reference like 3, 3/1 or 3/1/2</source>
        <translation>'%1'은(는) 3, 3/1, 3/1/2 같은 정점 참조가 아닙니다</translation>
    </message>
    <message>
        <source>there is no vertex %1</source>
        <translation>정점 %1이(가) 없습니다</translation>
    </message>
    <message>
        <source>a vertex has 3 coordinates (and 3 or 4 colour values), not %1</source>
        <translation>정점의 좌표는 3개(색상 값은 3개 또는 4개)여야 하는데 %1개입니다</translation>
    </message>
    <message>
        <source>a texture coordinate has too few numbers</source>
        <translation>텍스처 좌표의 숫자가 부족합니다</translation>
    </message>
    <message>
        <source>a normal has too few numbers</source>
        <translation>노멀의 숫자가 부족합니다</translation>
    </message>
    <message>
        <source>a polyline needs at least 2 vertices</source>
        <translation>폴리라인에는 정점이 2개 이상 필요합니다</translation>
    </message>
    <message>
        <source>'%1' is not the number of a smoothing group</source>
        <translation>'%1'은(는) 스무딩 그룹 번호가 아닙니다</translation>
    </message>
    <message>
        <source>a tag has no name</source>
        <translation>태그에 이름이 없습니다</translation>
    </message>
    <message>
        <source>a crease has two vertices for each edge, and one sharpness or one for each edge</source>
        <translation>크리스에는 에지마다 정점 두 개가 있고, 날카로움은 하나이거나 에지마다 하나입니다</translation>
    </message>
    <message>
        <source>a corner has vertices, and one sharpness or one for each of them</source>
        <translation>corner에는 정점이 있고, 날카로움은 하나이거나 정점마다 하나입니다</translation>
    </message>
    <message>
        <source>the statement '%1' does not exist in OBJ</source>
        <translation>OBJ에 '%1' 명령이 없습니다</translation>
    </message>
    <message>
        <source>the element uses vertex number %1, %2</source>
        <translation>요소가 정점 번호 %1을(를) 사용합니다. %2</translation>
    </message>
    <message>
        <source>the element uses texture coordinate number %1, %2</source>
        <translation>요소가 텍스처 좌표 번호 %1을(를) 사용합니다. %2</translation>
    </message>
    <message>
        <source>the element uses normal number %1, %2</source>
        <translation>요소가 노멀 번호 %1을(를) 사용합니다. %2</translation>
    </message>
    <message>
        <source>but OBJ counts from 1</source>
        <translation>그러나 OBJ는 1부터 셉니다</translation>
    </message>
    <message>
        <source>but only %1 stand before it</source>
        <translation>그러나 앞에는 %1개뿐입니다</translation>
    </message>
    <message>
        <source>but the file has %1</source>
        <translation>그러나 파일에는 %1개가 있습니다</translation>
    </message>
    <message>
        <source>the weights of %1 vertices were passed over</source>
        <translation>정점 %1개의 가중치를 건너뛰었습니다</translation>
    </message>
    <message>
        <source>the file holds more than its header announces</source>
        <translation>파일에 머리글이 알린 것보다 많은 데이터가 있습니다</translation>
    </message>
    <message>
        <source>the file ends after %1 of %2 vertices</source>
        <translation>파일이 정점 %2개 중 %1개 뒤에서 끝납니다</translation>
    </message>
    <message>
        <source>the file ends after %1 of %2 faces</source>
        <translation>파일이 페이스 %2개 중 %1개 뒤에서 끝납니다</translation>
    </message>
    <message>
        <source>the file holds nothing but comments</source>
        <translation>파일에 주석만 있습니다</translation>
    </message>
    <message>
        <source>binary OFF is not read; save it as text</source>
        <translation>바이너리 OFF는 읽지 않습니다. 텍스트로 저장하세요</translation>
    </message>
    <message>
        <source>the file ends before its counts</source>
        <translation>파일이 개수보다 앞에서 끝납니다</translation>
    </message>
    <message>
        <source>'%1' has points of another dimension than three</source>
        <translation>'%1'의 점이 3차원이 아닙니다</translation>
    </message>
    <message>
        <source>an OFF file begins with OFF, COFF, NOFF or the like, not with '%1'</source>
        <translation>OFF 파일은 '%1'이(가) 아니라 OFF, COFF, NOFF 등으로 시작합니다</translation>
    </message>
    <message>
        <source>the numbers of vertices, faces and edges must stand here</source>
        <translation>이곳에 정점, 페이스, 에지의 개수가 있어야 합니다</translation>
    </message>
    <message>
        <source>the header claims %1 vertices and %2 faces, more than the rest of the file can hold</source>
        <translation>머리글에는 정점 %1개와 페이스 %2개가 있다고 하지만 나머지 파일에 담을 수 있는 것보다 많습니다</translation>
    </message>
    <message>
        <source>vertex %1 has %2 values, not %3 and a colour of 3 or 4</source>
        <translation>정점 %1의 값이 %2개인데 %3개와 3개 또는 4개의 색상 값이어야 합니다</translation>
    </message>
    <message>
        <source>the colour of vertex %1 is not made of numbers</source>
        <translation>정점 %1의 색상이 숫자가 아닙니다</translation>
    </message>
    <message>
        <source>face %1 claims '%2' corners, but its line has %3 values after that</source>
        <translation>페이스 %1의 꼭짓점이 '%2'개라고 하지만 그 행에는 값이 %3개 있습니다</translation>
    </message>
    <message>
        <source>'%1' is not the index of a vertex</source>
        <translation>'%1'은(는) 정점 인덱스가 아닙니다</translation>
    </message>
    <message>
        <source>indices into a colour map were passed over, the file has no map</source>
        <translation>파일에 컬러 맵이 없어 컬러 맵 인덱스를 건너뛰었습니다</translation>
    </message>
    <message>
        <source>what follows the corners of face %1 is no colour</source>
        <translation>페이스 %1의 꼭짓점 뒤에 있는 것이 색상이 아닙니다</translation>
    </message>
    <message>
        <source>a PLY file begins with the line 'ply'</source>
        <translation>PLY 파일은 'ply' 행으로 시작합니다</translation>
    </message>
    <message>
        <source>the header has no end_header</source>
        <translation>머리글에 end_header가 없습니다</translation>
    </message>
    <message>
        <source>the header names no format</source>
        <translation>머리글에 형식이 없습니다</translation>
    </message>
    <message>
        <source>'%1' does not belong in a PLY header</source>
        <translation>'%1'은(는) PLY 머리글에 올 수 없습니다</translation>
    </message>
    <message>
        <source>'%1' is not a PLY format</source>
        <translation>'%1'은(는) PLY 형식이 아닙니다</translation>
    </message>
    <message>
        <source>only version 1.0 of PLY is known</source>
        <translation>PLY 버전 1.0만 읽을 수 있습니다</translation>
    </message>
    <message>
        <source>an element needs a name and a count</source>
        <translation>요소에는 이름과 개수가 필요합니다</translation>
    </message>
    <message>
        <source>'%1' is not a number of elements</source>
        <translation>'%1'은(는) 요소의 개수가 아닙니다</translation>
    </message>
    <message>
        <source>the element '%1' comes twice</source>
        <translation>요소 '%1'이(가) 두 번 나옵니다</translation>
    </message>
    <message>
        <source>a property stands before the first element</source>
        <translation>첫 요소보다 앞에 속성이 있습니다</translation>
    </message>
    <message>
        <source>the length of a list must be an integer</source>
        <translation>목록의 길이는 정수여야 합니다</translation>
    </message>
    <message>
        <source>a property needs a name</source>
        <translation>속성에는 이름이 필요합니다</translation>
    </message>
    <message>
        <source>the property '%1' comes twice</source>
        <translation>속성 '%1'이(가) 두 번 나옵니다</translation>
    </message>
    <message>
        <source>'%1' is not a PLY type</source>
        <translation>'%1'은(는) PLY 유형이 아닙니다</translation>
    </message>
    <message>
        <source>the header claims %1 elements '%2', but the rest of the file can hold no more than %3</source>
        <translation>머리글에는 요소 '%2'이(가) %1개 있다고 하지만 나머지 파일에는 %3개까지만 담을 수 있습니다</translation>
    </message>
    <message>
        <source>the range grid has %1 places; that needs the header's lines 'obj_info num_cols' and 'obj_info num_rows' with two numbers of that product, but they say %2 and %3</source>
        <translation>거리 격자의 칸이 %1개입니다. 머리글의 'obj_info num_cols'와 'obj_info num_rows'의 곱이 그와 같아야 하는데 %2과(와) %3입니다</translation>
    </message>
    <message>
        <source>place %1 of the range grid names %2 vertices; a scanner sees one there or none</source>
        <translation>거리 격자의 칸 %1에 정점이 %2개 있습니다. 스캐너는 하나만 보거나 보지 못합니다</translation>
    </message>
    <message>
        <source>place %1 of the range grid uses vertex %2, but the file has %3 vertices</source>
        <translation>거리 격자의 칸 %1이(가) 정점 %2을(를) 사용하지만 파일의 정점은 %3개입니다</translation>
    </message>
    <message>
        <source>%1 triangles of the range grid would cross a step in depth (an edge longer than 4 times the median); they were left out</source>
        <translation>거리 격자의 삼각형 %1개가 깊이의 단차를 가로질러(에지가 중앙값의 4배를 넘음) 제외했습니다</translation>
    </message>
    <message>
        <source>the list '%1' of faces was passed over</source>
        <translation>페이스의 목록 '%1'을(를) 건너뛰었습니다</translation>
    </message>
    <message>
        <source>the file has no element 'vertex'</source>
        <translation>파일에 'vertex' 요소가 없습니다</translation>
    </message>
    <message>
        <source>%1 elements '%2' were passed over</source>
        <translation>요소 '%2' %1개를 건너뛰었습니다</translation>
    </message>
    <message>
        <source>the file holds more data than its header announces</source>
        <translation>파일에 머리글이 알린 것보다 많은 데이터가 있습니다</translation>
    </message>
    <message>
        <source>'%1' has no list vertex_indices of integers</source>
        <translation>'%1'에 정수 목록 vertex_indices가 없습니다</translation>
    </message>
    <message>
        <source>the vertices lack x, y or z</source>
        <translation>정점에 x, y, z가 모두 있지 않습니다</translation>
    </message>
    <message>
        <source>the list '%1' of vertices was passed over</source>
        <translation>정점의 목록 '%1'을(를) 건너뛰었습니다</translation>
    </message>
    <message>
        <source>the file has both faces and triangle strips</source>
        <translation>파일에 페이스와 삼각형 스트립이 모두 있습니다</translation>
    </message>
    <message>
        <source>the range grid was passed over: the file has faces of its own</source>
        <translation>파일에 페이스가 있어 거리 격자를 건너뛰었습니다</translation>
    </message>
    <message>
        <source>the edges lack vertex1 or vertex2 as integers</source>
        <translation>에지에 정수 vertex1이나 vertex2가 없습니다</translation>
    </message>
    <message>
        <source>element %1 of '%2' uses vertex %3, but the file has %4 vertices</source>
        <translation>'%2'의 요소 %1이(가) 정점 %3을(를) 사용하지만 파일의 정점은 %4개입니다</translation>
    </message>
    <message>
        <source>the file ends in element %1 of %2 elements '%3'</source>
        <translation>파일이 '%3' 요소 %2개 중 %1번째 안에서 끝납니다</translation>
    </message>
    <message>
        <source>the file ends after %1 of %2 elements '%3'</source>
        <translation>파일이 '%3' 요소 %2개 중 %1개 뒤에서 끝납니다</translation>
    </message>
    <message>
        <source>a list has the length %1</source>
        <translation>목록의 길이가 %1입니다</translation>
    </message>
    <message>
        <source>the line has more values than '%1' has properties</source>
        <translation>행의 값이 '%1'의 속성보다 많습니다</translation>
    </message>
    <message>
        <source>the line has too few values for '%1'</source>
        <translation>행의 값이 '%1'에 비해 부족합니다</translation>
    </message>
    <message>
        <source>'%1' is not a value of type %2</source>
        <translation>'%1'은(는) %2 유형의 값이 아닙니다</translation>
    </message>
    <message>
        <source>'%1' is not the length of a list</source>
        <translation>'%1'은(는) 목록의 길이가 아닙니다</translation>
    </message>
    <message>
        <source>this is neither a text STL nor long enough for a binary one</source>
        <translation>텍스트 STL이 아니고 바이너리 STL이라기에는 너무 짧습니다</translation>
    </message>
    <message>
        <source>the header claims %1 facets, but the file holds only %2</source>
        <translation>머리글에는 삼각형이 %1개 있다고 하지만 파일에는 %2개뿐입니다</translation>
    </message>
    <message>
        <source>the header claims %1 facets, but the file holds %2</source>
        <translation>머리글에는 삼각형이 %1개 있다고 하지만 파일에는 %2개가 있습니다</translation>
    </message>
    <message>
        <source>%1 bytes after the last facet were passed over</source>
        <translation>마지막 삼각형 뒤의 %1바이트를 건너뛰었습니다</translation>
    </message>
    <message>
        <source>the file ends where '%1' must follow</source>
        <translation>'%1'이(가) 와야 할 곳에서 파일이 끝납니다</translation>
    </message>
    <message>
        <source>'%1' stands where '%2' must follow</source>
        <translation>'%2'이(가) 와야 할 곳에 '%1'이(가) 있습니다</translation>
    </message>
    <message>
        <source>facet %1 has %2 corners, and STL knows triangles only</source>
        <translation>패싯 %1의 꼭짓점이 %2개인데 STL에는 삼각형만 있습니다</translation>
    </message>
    <message>
        <source>the model needs the extension '%1', which isn't read: export it without</source>
        <translation>모델에 읽을 수 없는 확장 '%1'이(가) 필요합니다. 그 확장 없이 내보내세요</translation>
    </message>
    <message>
        <source>%1 has %2 elements, but %3 has %4 positions</source>
        <translation>%1의 요소는 %2개인데 %3의 위치는 %4개입니다</translation>
    </message>
    <message>
        <source>%1 has no attributes</source>
        <translation>%1에 속성이 없습니다</translation>
    </message>
    <message>
        <source>%1 has no positions</source>
        <translation>%1에 위치가 없습니다</translation>
    </message>
    <message>
        <source>%1 has %2 corners, which make no whole number of triangles</source>
        <translation>%1의 꼭짓점이 %2개여서 삼각형으로 나누어떨어지지 않습니다</translation>
    </message>
    <message>
        <source>%1 uses vertex %2 of %3</source>
        <translation>%1이(가) %3개 중 정점 %2을(를) 사용합니다</translation>
    </message>
    <message>
        <source>'mode' of %1 is none of glTF's</source>
        <translation>%1의 'mode'가 glTF의 값이 아닙니다</translation>
    </message>
    <message>
        <source>%1 has no list of primitives</source>
        <translation>%1에 프리미티브 목록이 없습니다</translation>
    </message>
    <message>
        <source>%1 is no object</source>
        <translation>%1이(가) 객체가 아닙니다</translation>
    </message>
    <message>
        <source>%1 were passed over: a mesh holds none</source>
        <translation>메쉬에 담을 수 없는 것을 건너뛰었습니다: %1</translation>
    </message>
    <message>
        <source>textures</source>
        <translation>텍스처</translation>
    </message>
    <message>
        <source>skins</source>
        <translation>스킨</translation>
    </message>
    <message>
        <source>animations</source>
        <translation>애니메이션</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>morph targets</source>
        <translation>모프 타깃</translation>
    </message>
    <message>
        <source>further attributes</source>
        <translation>그 밖의 속성</translation>
    </message>
    <message>
        <source>primitive %1 of mesh %2</source>
        <translation>메쉬 %2의 프리미티브 %1</translation>
    </message>
    <message>
        <source>accessor %1</source>
        <translation>접근자 %1</translation>
    </message>
    <message>
        <source>buffer view %1</source>
        <translation>버퍼 뷰 %1</translation>
    </message>
    <message>
        <source>mesh %1</source>
        <translation>메쉬 %1</translation>
    </message>
    <message>
        <source>the model's description is no object</source>
        <translation>모델의 설명이 객체가 아닙니다</translation>
    </message>
    <message>
        <source>the model's description names no version 2 of glTF</source>
        <translation>모델의 설명에 glTF 버전 2가 없습니다</translation>
    </message>
    <message>
        <source>%1 uses entry %2 of '%3', which has %4</source>
        <translation>%1이(가) '%3'의 항목 %2을(를) 사용하지만 항목은 %4개입니다</translation>
    </message>
    <message>
        <source>entry %1 of '%2' is no object</source>
        <translation>'%2'의 항목 %1이(가) 객체가 아닙니다</translation>
    </message>
    <message>
        <source>'%1' of %2 is no whole number from 0</source>
        <translation>%2의 '%1'이(가) 0 이상의 정수가 아닙니다</translation>
    </message>
    <message>
        <source>'%1' of %2 is no list of %3 numbers</source>
        <translation>%2의 '%1'이(가) 숫자 %3개의 목록이 아닙니다</translation>
    </message>
    <message>
        <source>'%1' of %2 is no list of whole numbers from 0</source>
        <translation>%2의 '%1'이(가) 0 이상의 정수 목록이 아닙니다</translation>
    </message>
    <message>
        <source>the file ends within the header of a chunk</source>
        <translation>파일이 청크의 머리글 안에서 끝납니다</translation>
    </message>
    <message>
        <source>a chunk claims %1 bytes, but only %2 follow</source>
        <translation>청크가 %1바이트라고 하지만 %2바이트만 남아 있습니다</translation>
    </message>
    <message>
        <source>the file doesn't begin with 'glTF'</source>
        <translation>파일이 'glTF'로 시작하지 않습니다</translation>
    </message>
    <message>
        <source>the file ends within its header</source>
        <translation>파일이 머리글 안에서 끝납니다</translation>
    </message>
    <message>
        <source>this is glTF version %1, and only version 2 is read</source>
        <translation>glTF 버전이 %1인데 버전 2만 읽습니다</translation>
    </message>
    <message>
        <source>the header claims %1 bytes, but the file has %2</source>
        <translation>머리글에는 %1바이트라고 하지만 파일은 %2바이트입니다</translation>
    </message>
    <message>
        <source>%1 bytes after the model were passed over</source>
        <translation>모델 뒤의 %1바이트를 건너뛰었습니다</translation>
    </message>
    <message>
        <source>the header claims less than itself</source>
        <translation>머리글에 적힌 크기가 머리글보다 작습니다</translation>
    </message>
    <message>
        <source>the first chunk isn't JSON</source>
        <translation>첫 청크가 JSON이 아닙니다</translation>
    </message>
    <message>
        <source>%1 is its own descendant</source>
        <translation>%1이(가) 자기 자신의 하위에 있습니다</translation>
    </message>
    <message>
        <source>%1 has two parents</source>
        <translation>%1의 부모가 둘입니다</translation>
    </message>
    <message>
        <source>'componentType' of %1 is none of glTF's</source>
        <translation>%1의 'componentType'이 glTF의 값이 아닙니다</translation>
    </message>
    <message>
        <source>%1 lies outside of the file's binary part: export the model as one GLB file</source>
        <translation>%1이(가) 파일의 바이너리 부분 밖에 있습니다. 모델을 GLB 파일 하나로 내보내세요</translation>
    </message>
    <message>
        <source>%1 claims %2 bytes, but the file holds %3</source>
        <translation>%1이(가) %2바이트라고 하지만 파일에는 %3바이트가 있습니다</translation>
    </message>
    <message>
        <source>%1 names no buffer</source>
        <translation>%1에 버퍼가 지정되지 않았습니다</translation>
    </message>
    <message>
        <source>%1 reaches beyond its buffer of %2 bytes</source>
        <translation>%1이(가) %2바이트 버퍼를 벗어납니다</translation>
    </message>
    <message>
        <source>%1 begins beyond its buffer view</source>
        <translation>%1이(가) 버퍼 뷰 밖에서 시작합니다</translation>
    </message>
    <message>
        <source>the elements of %1 overlap each other</source>
        <translation>%1의 요소들이 서로 겹칩니다</translation>
    </message>
    <message>
        <source>%1 claims %2 elements, more than its buffer view holds</source>
        <translation>%1의 요소가 %2개라고 하지만 버퍼 뷰에 담긴 것보다 많습니다</translation>
    </message>
    <message>
        <source>%1 claims %2 elements, more than the file has bytes</source>
        <translation>%1의 요소가 %2개라고 하지만 파일의 바이트 수보다 많습니다</translation>
    </message>
    <message>
        <source>the type of %1 doesn't fit its use by %2</source>
        <translation>%1의 유형이 %2의 사용에 맞지 않습니다</translation>
    </message>
    <message>
        <source>the sparse part of %1 has no '%2'</source>
        <translation>%1의 sparse 부분에 '%2'이(가) 없습니다</translation>
    </message>
    <message>
        <source>the sparse indices of %1 aren't whole numbers</source>
        <translation>%1의 sparse 인덱스가 정수가 아닙니다</translation>
    </message>
    <message>
        <source>the sparse part of %1 names element %2 of %3</source>
        <translation>%1의 sparse 부분이 %3개 중 요소 %2을(를) 가리킵니다</translation>
    </message>
    <message>
        <source>%1 is used as indices, but holds no whole numbers from 0</source>
        <translation>%1이(가) 인덱스로 쓰이지만 0 이상의 정수가 아닙니다</translation>
    </message>
    <message>
        <source>The copy of "%1" on the far side is left out, since it has no sound union with what it belongs to: draw it further away</source>
        <translation>"%1"의 반대쪽 복사는 붙어 있는 부위와 올바르게 합쳐지지 않아 만들지 않았습니다: 더 떨어뜨려 그리세요</translation>
    </message>
    <message>
        <source>"%1" is a hole</source>
        <translation>"%1": 구멍</translation>
    </message>
    <message>
        <source>"%1" is a part in front</source>
        <translation>"%1": 앞쪽 부위</translation>
    </message>
    <message>
        <source>"%1" is a limb of one line</source>
        <translation>"%1": 선 하나로 된 팔다리</translation>
    </message>
    <message>
        <source>"%1" is a line on the surface</source>
        <translation>"%1": 서피스 위의 선</translation>
    </message>
    <message>
        <source>"%1" is left out</source>
        <translation>"%1": 제외됨</translation>
    </message>
    <message>
        <source>"%1" is an outline</source>
        <translation>"%1": 윤곽선</translation>
    </message>
    <message>
        <source>"%1" goes behind "%2"</source>
        <translation>"%1": "%2" 뒤로 지나감</translation>
    </message>
    <message>
        <source>"%1" passes over "%2"</source>
        <translation>"%1": "%2" 위로 지나감</translation>
    </message>
    <message>
        <source>the start of "%1"</source>
        <translation>"%1"의 시작</translation>
    </message>
    <message>
        <source>the end of "%1"</source>
        <translation>"%1"의 끝</translation>
    </message>
    <message>
        <source>%1 and %2 joined</source>
        <translation>%1, %2 이어짐</translation>
    </message>
    <message>
        <source>%1 and %2 apart</source>
        <translation>%1, %2 떨어짐</translation>
    </message>
    <message>
        <source>%1 is joined to %2</source>
        <translation>%1: %2에 이어짐</translation>
    </message>
    <message>
        <source>the surface of "%1" goes on in another way</source>
        <translation>"%1"의 서피스가 다르게 이어짐</translation>
    </message>
    <message>
        <source>parts lie over one another in another way</source>
        <translation>부위가 겹치는 순서가 다름</translation>
    </message>
    <message>
        <source>What "%1" is joined to or apart from, "%2", names no two ends: write it as "end OTHER start"</source>
        <translation>"%1"이(가) 이어지거나 떨어지는 대상 "%2"이(가) 두 끝을 가리키지 않습니다. "end OTHER start"처럼 쓰십시오</translation>
    </message>
    <message>
        <source>An end can't be joined to itself: %1</source>
        <translation>끝을 자기 자신에 이을 수 없습니다: %1</translation>
    </message>
    <message>
        <source>They can't be joined, for "%1" is no open outline: %2; give it another kind, or join other ends</source>
        <translation>"%1"이(가) 열린 윤곽선이 아니어서 이을 수 없습니다: %2. 다른 종류를 지정하거나 다른 끝을 이으십시오</translation>
    </message>
    <message>
        <source>Two ends are set both to be joined and to be apart: %1; take one back</source>
        <translation>두 끝이 이어지는 것과 떨어지는 것으로 함께 지정되었습니다: %1. 하나를 취소하십시오</translation>
    </message>
    <message>
        <source>An end can be joined to one other end only: %1 to %2, or to %3</source>
        <translation>끝 하나는 다른 끝 하나에만 이을 수 있습니다: %1을(를) %2에, 또는 %3에</translation>
    </message>
    <message>
        <source>No solid looks like what is set for ends of strokes: %1; it is left out, or the strokes have to change</source>
        <translation>획의 끝에 지정한 것과 같은 솔리드가 없습니다: %1. 지정을 무시했거나 획을 바꾸어야 합니다</translation>
    </message>
</context>
</TS>
